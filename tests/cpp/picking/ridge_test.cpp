#include "picking/ridge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "errors.h"
#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

std::vector<std::int32_t> row(int first, int last) {
    std::vector<std::int32_t> path;
    for (int v = first; v <= last; ++v) path.push_back(v);
    return path;
}

bool same_line(std::vector<std::int32_t> a, const std::vector<std::int32_t>& b) {
    if (a == b) return true;
    std::reverse(a.begin(), a.end());
    return a == b;
}

TEST(WholeLine, IsTheFeatureLineToItsCorners) {
    const PickSurface surface = shapes::pick_surface(shapes::roof(8, 3, 90.0));
    EXPECT_TRUE(same_line(whole_line(surface, 3 * 9 + 4, 3 * 9 + 5), row(3 * 9, 3 * 9 + 8)));
    EXPECT_TRUE(same_line(whole_line(surface, 2, 3), row(0, 8))) << "a side of the boundary";
}

TEST(WholeLine, FollowsASmoothRidgeBothWays) {
    const PickSurface surface = shapes::pick_surface(shapes::ridge(12, 5, 1.0, 1.5), 80.0);
    EXPECT_TRUE(same_line(whole_line(surface, 5 * 13 + 6, 5 * 13 + 7), row(5 * 13, 5 * 13 + 12)));
}

TEST(WholeLine, ARidgeThatComesBackIsClosed) {
    const int n = 40;
    const PickSurface surface = shapes::pick_surface(shapes::torus(n, 12, 4.0, 1.0), 80.0);
    const std::vector<std::int32_t> line = whole_line(surface, 5, 6);  // the outer equator
    EXPECT_EQ(line.size(), static_cast<std::size_t>(n) + 1);
    EXPECT_EQ(line.front(), line.back());
}

TEST(WholeLine, IsJustTheEdgeWhereThereIsNoRidge) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(6, 6));
    EXPECT_EQ(whole_line(surface, 24, 25), (std::vector<std::int32_t>{24, 25}));
    EXPECT_THROW(whole_line(surface, 24, 26), Error);
    EXPECT_THROW(whole_line(surface, 24, 1000), Error);
}

TEST(SuggestLines, FindsRidgesSharpAndSmooth) {
    for (const shapes::Shape& shape : {shapes::roof(20, 8, 90.0), shapes::ridge(20, 8, 1.5, 1.0)}) {
        const auto lines = suggest_lines(shapes::pick_surface(shape, 60.0));
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(same_line(lines[0], row(8 * 21, 8 * 21 + 20)));
    }
}

TEST(SuggestLines, OffersNeitherValleysNorThePlane) {
    shapes::Shape valley = shapes::roof(20, 8, 90.0);
    for (Point& p : valley.points) p.z() = -p.z();
    EXPECT_TRUE(suggest_lines(shapes::pick_surface(valley)).empty());
    EXPECT_TRUE(suggest_lines(shapes::pick_surface(shapes::grid(10, 10))).empty());
}

TEST(SuggestLines, NoTwoAreNearEachOther) {
    const PickSurface surface = shapes::pick_surface(shapes::ridge(40, 20, 6.0, 4.0), 80.0);
    EXPECT_LE(suggest_lines(surface).size(), 1U);
}

TEST(SuggestLines, TheLongestComesFirst) {
    const shapes::Shape two =
        shapes::joined(shapes::roof(10, 4, 90.0), shapes::placed(shapes::roof(16, 4, 90.0), 1.0, Point(0, 12, 0)));
    const PickSurface surface = shapes::pick_surface(two);
    const auto lines = suggest_lines(surface);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_GT(shapes::length(surface.points, lines[0]), shapes::length(surface.points, lines[1]));
}

}  // namespace
}  // namespace anisoquad
