#include "prepare/size_field.h"

#include <gtest/gtest.h>

#include <numbers>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"
#include "strip_cylinder.h"

namespace anisoquad {
namespace {

/// Sizes that the field gives the nodes of its own input.
std::vector<double> sizes_on(const Surface& s, SizeFieldOptions options, double most_triangles = 0.0) {
    SurfaceMesh mesh = from_arrays(s.points, s.triangles);
    find_features(mesh, {}, {});
    find_patches(mesh);
    const ReferenceSurface reference(s.points, s.triangles);
    SizeField field(s.points, s.triangles, reference, options);
    if (most_triangles > 0.0) field.coarsen_to(most_triangles, s.points, s.triangles);
    std::vector<std::int32_t> hint;
    field.assign(mesh, hint, {});
    std::vector<double> sizes;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) sizes.push_back(mesh.info(Vertex(i)).size);
    return sizes;
}

TEST(SizeField, AnEdgeTurnsByTheCurvatureAngle) {
    const Surface s = strip_cylinder(48, 4, 1.0);  // radius 0.1
    for (const double size : sizes_on(s, {.largest = 1.0, .smallest = 1e-4, .curvature_angle = 30.0, .sagitta = 1.0})) {
        EXPECT_NEAR(size, 0.1 * std::numbers::pi / 6.0, 0.005);
    }
}

TEST(SizeField, AnEdgeLeavesTheSurfaceByTheSagittaAtTheMost) {
    const Surface s = strip_cylinder(48, 4, 1.0);
    const double sagitta = 1e-4;
    for (const double size : sizes_on(s, {.largest = 1.0, .smallest = 1e-4, .curvature_angle = 90.0, .sagitta = sagitta})) {
        EXPECT_NEAR(size * size / (8.0 * 0.1), sagitta, 0.2 * sagitta);
    }
}

TEST(SizeField, GrowthIsBoundedBetweenNeighbours) {
    const Surface s = strip_cylinder(48, 60, 1.0);
    std::vector<double> wanted(s.points.size(), 0.2);
    for (std::size_t i = 0; i < 48; ++i) wanted[i] = 0.01;
    const std::vector<double> sizes =
        sizes_on(s, {.largest = 0.2, .smallest = 1e-3, .curvature_angle = 0.0, .growth = 1.25, .vertex_size = wanted});
    for (std::size_t i = 48; i < sizes.size(); ++i) EXPECT_LE(sizes[i] - sizes[i - 48], 0.25 / 60.0 + 1e-9);
    EXPECT_GT(sizes.back(), 2.0 * sizes.front());
}

TEST(SizeField, ACapOnTheTrianglesMakesAllSizesLarger) {
    const Surface s = strip_cylinder(48, 4, 1.0);
    const SizeFieldOptions options{.largest = 0.01, .smallest = 1e-3, .curvature_angle = 0.0};
    const double area = 2.0 * std::numbers::pi * 0.1;
    const double before = 2.0 * area / (0.01 * 0.01);
    for (const double size : sizes_on(s, options, before / 4.0)) EXPECT_NEAR(size, 0.02, 1e-3);
    for (const double size : sizes_on(s, options, 4.0 * before)) EXPECT_NEAR(size, 0.01, 1e-6);
}

}  // namespace
}  // namespace anisoquad
