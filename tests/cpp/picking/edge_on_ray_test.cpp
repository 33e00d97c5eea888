#include "picking/edge_on_ray.h"

#include <gtest/gtest.h>

#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

const Eigen::Vector3d kDown(0.0, 0.0, -2.0);

std::pair<std::int32_t, std::int32_t> edge(const EdgeHit& hit) { return std::minmax(hit.from, hit.to); }

TEST(EdgeOnRay, IsTheNearestEdgeOfTheFacetThatIsMet) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(4, 3));
    for (const auto& [x, y] : {std::pair(1.5, 1.1), std::pair(2.5, 2.1)}) {
        const EdgeHit hit = edge_on_ray(surface, Point(x, y, 7.0), kDown);
        const std::int32_t left = static_cast<std::int32_t>(y) * 5 + static_cast<std::int32_t>(x);
        EXPECT_EQ(edge(hit), std::pair(left, left + 1));
        EXPECT_LT((hit.point - Point(x, y, 0.0)).norm(), 1e-12);
        const auto& t = surface.triangles[static_cast<std::size_t>(hit.facet)];
        EXPECT_TRUE(std::find(t.begin(), t.end(), hit.from) != t.end() && std::find(t.begin(), t.end(), hit.to) != t.end());
    }
}

TEST(EdgeOnRay, TheFirstOfSeveralSheetsIsMet) {
    const shapes::Shape lower = shapes::grid(3, 3);
    const PickSurface surface = shapes::pick_surface(shapes::joined(lower, shapes::placed(lower, 1.0, Point(0, 0, 2))));
    EXPECT_DOUBLE_EQ(edge_on_ray(surface, Point(1.4, 1.2, 9.0), kDown).point.z(), 2.0);
    EXPECT_DOUBLE_EQ(edge_on_ray(surface, Point(1.4, 1.2, -9.0), -kDown).point.z(), 0.0);
    EXPECT_DOUBLE_EQ(edge_on_ray(surface, Point(1.4, 1.2, 1.0), kDown).point.z(), 0.0) << "what is behind does not count";
}

TEST(EdgeOnRay, NothingIsMetBesideTheSurface) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(4, 3));
    const EdgeHit hit = edge_on_ray(surface, Point(-0.1, 1.5, 7.0), kDown);
    EXPECT_EQ(hit.facet, -1);
    EXPECT_EQ(hit.from, -1);
}

TEST(EdgeOnRay, BesideTheOutlineTheEdgeWithinReachCounts) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(4, 3));
    const EdgeHit hit = edge_on_ray(surface, Point(-0.1, 1.5, 7.0), kDown, 0.2);
    EXPECT_EQ(hit.facet, -1);
    EXPECT_EQ(edge(hit), std::pair(5, 10));
    EXPECT_EQ(edge_on_ray(surface, Point(-0.3, 1.5, 7.0), kDown, 0.2).from, -1);
}

TEST(EdgeOnRay, FeatureLinesWithinReachComeFirst) {
    const PickSurface surface = shapes::pick_surface(shapes::roof(4, 3, 90.0));
    const std::pair<std::int32_t, std::int32_t> ridge(3 * 5 + 1, 3 * 5 + 2);
    EXPECT_EQ(edge(edge_on_ray(surface, Point(1.5, 0.3, 7.0), kDown, 0.4)), ridge);
    EXPECT_NE(edge(edge_on_ray(surface, Point(1.5, 0.3, 7.0), kDown, 0.2)), ridge);
}

TEST(EdgeOnRay, WhatAFacetHidesIsNotMeant) {
    const shapes::Shape roof = shapes::roof(4, 3, 90.0);
    const shapes::Shape cover = shapes::placed(shapes::grid(8, 8), 1.0, Point(-2, -4, 5));
    const PickSurface surface = shapes::pick_surface(shapes::joined(roof, cover));
    const EdgeHit hit = edge_on_ray(surface, Point(1.5, 0.05, 7.0), kDown, 0.2);
    EXPECT_GE(std::min(hit.from, hit.to), static_cast<std::int32_t>(roof.points.size()));
}

}  // namespace
}  // namespace anisoquad
