#include "input/open_doubles.h"

#include <gtest/gtest.h>

#include "quad_mesh.h"
#include "shapes.h"

namespace anisoquad {
namespace {

/// A grid of 4 × 4 cells whose points (2, 0) to (2, 2) are two each, a crack from the border to its middle.
shapes::Shape cracked_grid(double width) {
    shapes::Shape shape = shapes::grid(4, 4);
    const std::vector<std::int32_t> line{2, 7};  // the crack ends in (2, 2)
    for (const std::int32_t v : line) {
        for (auto& triangle : shape.triangles) {
            double x = 0.0;
            for (const std::int32_t w : triangle) x += shape.points[static_cast<std::size_t>(w)].x() / 3.0;
            if (x < 2.0) continue;
            for (std::int32_t& w : triangle) w = w == v ? static_cast<std::int32_t>(shape.points.size()) : w;
        }
        shape.points.push_back(shape.points[static_cast<std::size_t>(v)] + Point(width, 0, 0));
    }
    return shape;
}

TEST(OpenDoubles, AreCountedAlongACrack) {
    EXPECT_EQ(count_open_doubles(cracked_grid(0.0).mesh()), 2);
    EXPECT_EQ(count_open_doubles(cracked_grid(1e-12).mesh()), 2);
}

TEST(OpenDoubles, AreNotThoseOfAGap) { EXPECT_EQ(count_open_doubles(cracked_grid(0.01).mesh()), 0); }

TEST(OpenDoubles, DoNotOccurOnASoundSurface) {
    EXPECT_EQ(count_open_doubles(shapes::grid(4, 4).mesh()), 0);
    EXPECT_EQ(count_open_doubles(shapes::cube(3).mesh()), 0);
}

/// They touch each other, and are no cracks.
TEST(OpenDoubles, AreNotThoseOfClosedSurfaces) {
    shapes::Shape shape = shapes::cube(2);
    const auto n = static_cast<std::int32_t>(shape.points.size());
    const shapes::Shape other = shapes::cube(2);
    for (const Point& p : other.points) shape.points.push_back(p + Point(2, 0, 0));
    for (const auto& [a, b, c] : other.triangles) shape.triangles.push_back({a + n, b + n, c + n});
    EXPECT_EQ(count_open_doubles(shape.mesh()), 0);
}

TEST(OpenDoubles, AreWarnedOfUntilTheyAreRepaired) {
    const shapes::Shape shape = cracked_grid(0.0);
    Options options;
    const QuadMeshResult cracked = quad_mesh(shape.points, shape.triangles, {}, options);
    ASSERT_EQ(cracked.report.warnings.size(), 1U);
    EXPECT_EQ(cracked.report.warnings.front(),
              "2 vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it");
    options.repair = true;
    const QuadMeshResult repaired = quad_mesh(shape.points, shape.triangles, {}, options);
    ASSERT_EQ(repaired.report.warnings.size(), 1U);
    EXPECT_EQ(repaired.report.warnings.front(), "the input was repaired: 2 vertices welded");
}

}  // namespace
}  // namespace anisoquad
