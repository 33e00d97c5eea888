#include "prepare/size_range.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace anisoquad {
namespace {

/// A unit square of n × n pairs of triangles.
shapes::Shape square(int n) {
    shapes::Shape s = shapes::grid(n, n);
    for (Point& p : s.points) p /= n;
    return s;
}

TEST(SizeRange, FollowsTheTrianglesWhereNothingIsAskedFor) {
    const shapes::Shape s = square(60);
    const SizeRange range = size_range(s.points, s.triangles, 1.0, 1.0, {});
    EXPECT_NEAR(range.largest * 60.0, 1.0, 0.2);  // about the side of a square of two triangles
    EXPECT_LT(range.smallest, range.largest);
    EXPECT_GT(range.smallest, 0.1 * range.largest);
}

TEST(SizeRange, StaysInProportionToTheModel) {
    const shapes::Shape coarse = square(1);
    EXPECT_LE(size_range(coarse.points, coarse.triangles, 1.0, 1.0, {}).largest, 0.05);
    const shapes::Shape fine = square(800);
    EXPECT_GE(size_range(fine.points, fine.triangles, 1.0, 1.0, {}).largest, 0.003);
}

TEST(SizeRange, AnAskedSizeIsInTheUsersUnit) {
    const shapes::Shape s = square(10);
    Options options;
    options.size = 5.0;
    EXPECT_DOUBLE_EQ(size_range(s.points, s.triangles, 1.0, 100.0, options).largest, 0.05);
    options.vertex_size.assign(s.points.size(), 2.0);
    options.vertex_size[3] = 8.0;
    EXPECT_DOUBLE_EQ(size_range(s.points, s.triangles, 1.0, 100.0, options).largest, 0.08);
}

}  // namespace
}  // namespace anisoquad
