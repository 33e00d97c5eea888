#include "features/ridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"

namespace anisoquad {
namespace {

/// A sheet that comes in along x at z = radius, turns round half a circle about the y axis and goes back at z = −radius.
SurfaceMesh fold(double radius, int round, int length) {
    std::vector<Point> profile;
    for (int i = 0; i < 8; ++i) profile.emplace_back(1.0 - i / 8.0, 0.0, radius);
    for (int i = 0; i <= round; ++i) {
        const double a = std::numbers::pi * (0.5 + static_cast<double>(i) / round);
        profile.emplace_back(radius * std::cos(a), 0.0, radius * std::sin(a));
    }
    for (int i = 1; i <= 8; ++i) profile.emplace_back(i / 8.0, 0.0, -radius);
    const int n = static_cast<int>(profile.size());
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (int j = 0; j <= length; ++j) {
        for (const Point& p : profile) points.emplace_back(p.x(), static_cast<double>(j) / length, p.z());
    }
    for (int j = 0; j < length; ++j) {
        for (int i = 0; i + 1 < n; ++i) {
            const int a = j * n + i;
            triangles.push_back({a, a + 1, a + 1 + n});
            triangles.push_back({a, a + 1 + n, a + n});
        }
    }
    SurfaceMesh mesh = from_arrays(points, triangles);
    find_features(mesh, {}, {});
    find_patches(mesh);
    return mesh;
}

TEST(FindRidges, ASharpFoldGetsOneLineAlongItsMiddle) {
    const double radius = 0.01;
    const SurfaceMesh mesh = fold(radius, 8, 20);
    const std::vector<char> patches(1, 1);
    const Ridges ridges = find_ridges(mesh, patches, {.width = 0.05});
    EXPECT_EQ(ridges.edges.size(), 20U);
    for (const auto& edge : ridges.edges) {
        for (const std::int32_t v : edge) {
            EXPECT_NEAR(mesh.position(Vertex(v)).x(), -radius, 0.1 * radius);
            EXPECT_NEAR(mesh.position(Vertex(v)).z(), 0.0, 0.4 * radius);
        }
    }
}

TEST(FindRidges, WhatElementsCanFollowIsNoRidge) {
    const SurfaceMesh mesh = fold(0.3, 24, 20);
    const std::vector<char> patches(1, 1);
    EXPECT_TRUE(find_ridges(mesh, patches, {.width = 0.05}).edges.empty());
}

TEST(FindRidges, OnlyTheGivenPatchesAreLookedAt) {
    const SurfaceMesh mesh = fold(0.01, 8, 20);
    const std::vector<char> patches(1, 0);
    EXPECT_TRUE(find_ridges(mesh, patches, {.width = 0.05}).edges.empty());
}

TEST(FindRidges, ASourceStandsForTheFoldThatItLiesOn) {
    SurfaceMesh mesh = fold(0.01, 8, 20);
    const std::vector<char> patches(1, 1);
    Source source;
    source.vertices.push_back(find_ridges(mesh, patches, {.width = 0.05}).edges.front()[0]);
    for (const int step : {25, -25}) {  // the profile has 25 points: the neighbours along the fold
        for (std::int32_t v = source.vertices.front() + step; v >= 0 && v < mesh.vertex_slots(); v += step) {
            source.vertices.insert(step > 0 ? source.vertices.end() : source.vertices.begin(), v);
        }
    }
    find_features(mesh, {&source, 1}, {});
    find_patches(mesh);
    EXPECT_TRUE(find_ridges(mesh, std::vector<char>(2, 1), {.width = 0.05}).edges.empty());
}

TEST(FindRidges, ARidgeEndsBeforeALineThatItWouldMeetAtASmallAngle) {
    constexpr std::int32_t kProfile = 25;
    SurfaceMesh mesh = fold(0.01, 8, 20);
    const std::vector<char> patches(1, 1);
    const std::int32_t column = find_ridges(mesh, patches, {.width = 0.05}).edges.front()[0] % kProfile;
    // An edge beside the ridge, from the lower left, that ends on it.
    const std::int32_t end = 16 * kProfile + column;
    Options options;
    options.feature_edges = {{end - kProfile - 1, end}};
    find_features(mesh, {}, options);
    const Ridges ridges = find_ridges(mesh, patches, {.width = 0.05});
    EXPECT_EQ(ridges.edges.size(), 19U);
    const auto touches = [&](std::int32_t v) {
        return std::any_of(ridges.edges.begin(), ridges.edges.end(),
                           [&](const auto& e) { return std::minmax(e[0], e[1]) == std::minmax(v, end); });
    };
    EXPECT_FALSE(touches(end - kProfile)) << "between the two it would be too narrow";
    EXPECT_TRUE(touches(end + kProfile)) << "on the other side there is room";
}

TEST(FindRidges, RidgesBecomeLinesOfTheirOwn) {
    SurfaceMesh mesh = fold(0.01, 8, 20);
    const std::vector<char> patches(1, 1);
    const Ridges ridges = find_ridges(mesh, patches, {.width = 0.05});
    int found = 0;
    for (const FeatureLine& line : find_features(mesh, {}, {}, ridges.edges)) {
        found += line.is_ridge;
        if (line.is_ridge) {
            EXPECT_EQ(line.nodes.size(), 21U);
        }
    }
    EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace anisoquad
