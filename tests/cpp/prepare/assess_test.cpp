#include "prepare/assess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"
#include "strip_cylinder.h"

namespace anisoquad {
namespace {

PatchAssessment assess(const Surface& s, double sagitta = 0.1) {
    SurfaceMesh mesh = from_arrays(s.points, s.triangles);
    find_features(mesh, {}, {});
    EXPECT_EQ(find_patches(mesh), 1);
    return assess_patches(mesh, 30.0, sagitta).at(0);
}

/// A cylinder whose rings lie closer and closer: each is `step` times as high as the one before.
Surface graded_cylinder(double step) {
    Surface s = strip_cylinder(24, 30, 1.0);
    double z = 0.0;
    double height = 0.02;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        if (i % 24 == 0 && i > 0) {
            z += height;
            height *= step;
        }
        s.points[i].z() = z;
    }
    return s;
}

TEST(AssessPatches, LongThinTrianglesArePoor) {
    const PatchAssessment long_ones = assess(strip_cylinder(24, 1, 1.0));
    EXPECT_TRUE(long_ones.is_poor);
    EXPECT_EQ(long_ones.poor, long_ones.triangles);
    const PatchAssessment good = assess(strip_cylinder(24, 40, 1.0));
    EXPECT_FALSE(good.is_poor);
    EXPECT_EQ(good.poor, 0);
    EXPECT_EQ(good.triangles, 2 * 24 * 40);
}

/// A disk of triangles round its middle, as the ends of cylinders are in STL files.
Surface fan(int triangles) {
    Surface s;
    s.points.emplace_back(0.0, 0.0, 0.0);
    for (int i = 0; i < triangles; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / triangles;
        s.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        s.triangles.push_back({0, i + 1, (i + 1) % triangles + 1});
    }
    return s;
}

TEST(AssessPatches, TrianglesThatMakeNoUsableQuadWithAnyNeighbourArePoor) {
    const PatchAssessment thin = assess(fan(36));
    EXPECT_TRUE(thin.is_poor);
    EXPECT_EQ(thin.poor, 36);
    EXPECT_FALSE(assess(fan(12)).is_poor);
}

TEST(AssessPatches, AFewTrianglesThatHaveNoChoiceAreNotPoor) {
    Surface two;
    two.points = {{0, 0, 0}, {1, -0.2, 0}, {1, 0.2, 0}, {1.8, 0.0, 0}};
    two.triangles = {{0, 1, 2}, {1, 3, 2}};
    EXPECT_FALSE(assess(two).is_poor);
}

TEST(AssessPatches, SteepGradingIsSeenAndAGentleOneIsNot) {
    EXPECT_TRUE(assess(graded_cylinder(1.0 / 0.85)).is_graded || assess(graded_cylinder(1.0 / 0.85)).is_poor);
    EXPECT_FALSE(assess(graded_cylinder(1.02)).is_graded);
}

TEST(AssessPatches, TrianglesThatTurnTooFarAreCoarse) {
    EXPECT_TRUE(assess(strip_cylinder(10, 20, 1.0)).is_coarse);  // by 36 degrees, which is no feature line yet
    EXPECT_FALSE(assess(strip_cylinder(24, 20, 1.0)).is_coarse);
}

TEST(AssessPatches, TrianglesAreCoarseWhoseQuadsWouldLeaveTheSurface) {
    // Of radius 0.1, with facets 0.026 wide and 0.025 high: their middles are 0.026² / 0.8 off it.
    const Surface cylinder = strip_cylinder(24, 40, 1.0);
    EXPECT_TRUE(assess(cylinder, 6e-4).is_coarse);
    EXPECT_FALSE(assess(cylinder, 1.2e-3).is_coarse);
}

}  // namespace
}  // namespace anisoquad
