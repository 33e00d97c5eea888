#include "anisotropy/local_size.h"

#include <gtest/gtest.h>

#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

TEST(LocalSize, IsTheEdgeOfTheEquilateralTriangleOfTheSameArea) {
    for (const double scale : {1.0, 1e-6, 40.0}) {
        Prepared p(shapes::placed(shapes::grid(6, 5), scale, Point::Zero()));
        const LocalSize size(p.shape.points, p.shape.triangles, p.reference);
        std::int32_t hint = -1;
        for (const Point& at : p.shape.points) EXPECT_NEAR(size(at, hint), scale * std::sqrt(2.0 / std::sqrt(3.0)), 1e-9 * scale);
    }
}

TEST(LocalSize, FollowsTheTrianglesSmoothly) {
    shapes::Shape shape = shapes::grid(16, 4);
    for (Point& p : shape.points) p.x() = p.x() * p.x() / 4.0;
    Prepared p(shape);
    const LocalSize size(p.shape.points, p.shape.triangles, p.reference);
    std::int32_t hint = -1;
    double before = 0.0;
    for (int i = 0; i < 16; ++i) {
        const double middle = (i + 0.5) * (i + 0.5) / 4.0;
        const double here = size(Point(middle, 2.0, 0.0), hint);
        EXPECT_GT(here, before);
        EXPECT_TRUE(i <= 2 || here < 1.6 * before);
        before = here;
        const double own = std::sqrt(2.0 / std::sqrt(3.0) * (2 * i + 1) / 4.0);
        EXPECT_GT(here, 0.6 * own);
        EXPECT_TRUE(i == 0 || here < 1.7 * own);
    }
}

TEST(LocalSize, TheHintChangesNothing) {
    Prepared p(shapes::sphere(20, 14));
    const LocalSize size(p.shape.points, p.shape.triangles, p.reference);
    for (const Point& at : p.shape.points) {
        std::int32_t none = -1;
        std::int32_t far = 3;
        EXPECT_EQ(size(1.01 * at + Point(0.001, 0.002, 0.003), none), size(1.01 * at + Point(0.001, 0.002, 0.003), far));
        EXPECT_EQ(none, far);
        EXPECT_GE(none, 0);
    }
}

}  // namespace
}  // namespace anisoquad
