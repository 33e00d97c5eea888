#include "picking/best_path.h"

#include <gtest/gtest.h>

#include "errors.h"
#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

TEST(BestPath, IsTheShortestOnAPlane) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(12, 10));
    const std::vector<std::int32_t> path = best_path(surface, 5 * 13 + 2, 5 * 13 + 9);
    ASSERT_EQ(path.size(), 8U);
    for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(path[i], 5 * 13 + 2 + static_cast<std::int32_t>(i));
}

TEST(BestPath, NeighboursAreJoinedByEdges) {
    const PickSurface surface = shapes::pick_surface(shapes::unstructured(12));
    const std::vector<std::int32_t> path = best_path(surface, 14, 150);
    EXPECT_EQ(path.front(), 14);
    EXPECT_EQ(path.back(), 150);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        EXPECT_TRUE(surface.mesh.find_halfedge(Vertex(path[i]), Vertex(path[i + 1])).is_valid());
}

TEST(BestPath, FollowsAFeatureLineWhereThatIsLonger) {
    const PickSurface surface = shapes::pick_surface(shapes::roof(12, 5, 90.0));
    const auto row = [](int j, int i) { return (j + 5) * 13 + i; };
    const std::vector<std::int32_t> path = best_path(surface, row(1, 0), row(1, 12));
    int on_ridge = 0;
    for (const std::int32_t v : path) on_ridge += v >= row(0, 0) && v <= row(0, 12);
    EXPECT_GE(on_ridge, 10);
}

TEST(BestPath, FollowsASmoothConvexRidgeAndNoValley) {
    const shapes::Shape ridge = shapes::ridge(16, 6, 1.0, 1.5);
    const auto on_line = [](const std::vector<std::int32_t>& path) {
        int count = 0;
        for (const std::int32_t v : path) count += v >= 6 * 17 && v < 7 * 17;
        return count;
    };
    const auto from = 7 * 17;
    EXPECT_GE(on_line(best_path(shapes::pick_surface(ridge, 80.0), from, from + 16)), 13);
    shapes::Shape valley = ridge;
    for (Point& p : valley.points) p.z() = -p.z();
    EXPECT_LE(on_line(best_path(shapes::pick_surface(valley, 80.0), from, from + 16)), 2);
}

TEST(BestPath, TheBoundaryIsNoReasonForALongWay) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(20, 20));
    const std::vector<std::int32_t> path = best_path(surface, 10 * 21, 10 * 21 + 20);
    EXPECT_EQ(path.size(), 21U);
}

TEST(BestPath, EndsAndErrors) {
    const shapes::Shape one = shapes::grid(2, 2);
    const PickSurface surface = shapes::pick_surface(shapes::joined(one, shapes::placed(one, 1.0, Point(9, 0, 0))));
    EXPECT_EQ(best_path(surface, 4, 4), std::vector<std::int32_t>{4});
    EXPECT_TRUE(best_path(surface, 4, 12).empty()) << "another component";
    EXPECT_THROW(best_path(surface, 4, 99), Error);
    EXPECT_THROW(best_path(surface, -1, 4), Error);
}

}  // namespace
}  // namespace anisoquad
