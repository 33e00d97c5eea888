#include "prepare/source_spacing.h"

#include <gtest/gtest.h>

#include "features/patches.h"
#include "mesh/arrays.h"
#include "strip_cylinder.h"

namespace anisoquad {
namespace {

double spacing_of(const Surface& s, const std::vector<std::int32_t>& source, const SourceSpacingOptions& options) {
    SurfaceMesh mesh = from_arrays(s.points, s.triangles);
    const std::vector<Source> sources{{source, {{2, 0}}, Sides::both}};
    const std::vector<FeatureLine> lines = find_features(mesh, sources, {});
    find_patches(mesh);
    const ReferenceLines reference(mesh, lines);
    return source_spacing(mesh, line_nodes(mesh, lines, reference), lines, reference, 0, options);
}

TEST(SourceSpacing, FollowsTheCurvatureOfTheLinesAtTheEnds) {
    // Along a cylinder of radius 0.1 whose rims have 200 edges: a chord L leaves the circle by L²/8r.
    const Surface s = strip_cylinder(200, 1, 1.0);
    for (const double deviation : {2e-5, 1e-4, 5e-4}) {
        const double chord = std::sqrt(8.0 * 0.1 * deviation);
        const double spacing = spacing_of(s, {0, 200}, {0.1, 1e-3, deviation});
        EXPECT_LT(spacing, 1.1 * chord + 0.004);
        EXPECT_GT(spacing, 0.85 * chord);
    }
}

TEST(SourceSpacing, StaysWithinItsLimits) {
    const Surface s = strip_cylinder(200, 1, 1.0);
    EXPECT_EQ(spacing_of(s, {0, 200}, {0.005, 1e-3, 1e-3}), 0.005);
    EXPECT_EQ(spacing_of(s, {0, 200}, {0.1, 0.02, 1e-9}), 0.02);
}

TEST(SourceSpacing, StraightLinesAskForNothing) {
    Surface s;  // a plate with the source across it
    for (const double y : {0.0, 1.0, 2.0, 3.0, 4.0}) {
        for (const double x : {0.0, 5.0}) s.points.emplace_back(x, y, 0.0);
    }
    for (std::int32_t i = 0; i < 8; i += 2) {
        s.triangles.push_back({i, i + 1, i + 3});
        s.triangles.push_back({i, i + 3, i + 2});
    }
    EXPECT_EQ(spacing_of(s, {4, 5}, {0.5, 1e-3, 1e-6}), 0.5);
}

TEST(SourceSpacing, TheTighterEndCounts) {
    // The nose's radius is 0.008 at the root, and 0.6 of it at the tip.
    const double both = spacing_of(strip_nose(), {0, 1}, {0.05, 1e-4, 5e-5});
    EXPECT_LT(both, 2.2 * std::sqrt(8.0 * 0.6 * 0.008 * 5e-5));
    EXPECT_GT(both, 0.5 * std::sqrt(8.0 * 0.6 * 0.008 * 5e-5));
}

}  // namespace
}  // namespace anisoquad
