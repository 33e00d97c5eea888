#include "surface/facet_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "shapes.h"
#include "surface/closest_on_triangle.h"

namespace anisoquad {
namespace {

TEST(FacetTree, NeighboursShareTheirEdge) {
    const shapes::Shape shape = shapes::torus(12, 8);
    const FacetTree tree(shape.points, shape.triangles);
    for (std::int32_t f = 0; f < tree.count(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t g = tree.neighbour(f, k);
            ASSERT_GE(g, 0);  // a closed surface
            const auto& t = tree.facet(g);
            for (const int corner : {k, (k + 1) % 3}) {
                const std::int32_t v = tree.facet(f)[static_cast<std::size_t>(corner)];
                EXPECT_TRUE(t[0] == v || t[1] == v || t[2] == v);
            }
        }
    }
    const shapes::Shape open = shapes::grid(1, 1);
    const FacetTree two(open.points, open.triangles);
    int borders = 0;
    for (std::int32_t f = 0; f < 2; ++f) {
        for (int k = 0; k < 3; ++k) borders += two.neighbour(f, k) < 0;
    }
    EXPECT_EQ(borders, 4);
}

TEST(FacetTree, AWalkFromAnyHintEndsAtTheClosestFacetOrIsFollowedByASearch) {
    const shapes::Shape shape = shapes::torus(40, 20);
    const FacetTree tree(shape.points, shape.triangles);
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        const auto& t = tree.facet(static_cast<std::int32_t>(random() % static_cast<unsigned>(tree.count())));
        const double w = static_cast<double>(random() % 1000) / 1000.0;
        const Point p = w * tree.point(t[0]) + 0.5 * (1.0 - w) * (tree.point(t[1]) + tree.point(t[2])) + Point(0.0, 0.0, 1e-5);
        const auto hint = static_cast<std::int32_t>(random() % static_cast<unsigned>(tree.count()));
        const FacetTree::Hit exact = tree.closest(p, FacetTree::kAnyPatch, -1);
        EXPECT_EQ(tree.closest_or_within(p, FacetTree::kAnyPatch, hint, -1.0).facet, exact.facet);
        EXPECT_NEAR(std::sqrt(tree.closest(p, FacetTree::kAnyPatch, hint).distance2), std::sqrt(exact.distance2),
                    1e-4 * tree.diagonal());
    }
}

/// Patches of very different sizes, mixed in space; some numbers have no facet.
TEST(FacetTree, ASearchInOnePatchFindsWhatTryingAllItsFacetsFinds) {
    const shapes::Shape shape = shapes::torus(40, 20);
    std::vector<std::int32_t> patch;
    std::mt19937 random(5);
    for (std::size_t f = 0; f < shape.triangles.size(); ++f)
        patch.push_back(f % 3 != 0 ? 7 : static_cast<std::int32_t>(random() % 40) + 8);
    patch.front() = 3;  // a patch of one facet
    const FacetTree tree(shape.points, shape.triangles, patch);
    EXPECT_EQ(tree.closest(Point::Zero(), 5, -1).facet, -1);
    EXPECT_EQ(tree.closest(Point::Zero(), 100, -1).facet, -1);
    EXPECT_EQ(tree.closest(Point::Zero(), 3, -1).facet, 0);
    for (int i = 0; i < 300; ++i) {
        const Point p = 3.0 * Point::Random();
        const auto wanted = i % 3 == 0 ? FacetTree::kAnyPatch : static_cast<std::int32_t>(7 + i % 41);
        double least2 = std::numeric_limits<double>::infinity();
        for (std::int32_t f = 0; f < tree.count(); ++f) {
            if (wanted != FacetTree::kAnyPatch && tree.patch(f) != wanted) continue;
            const auto& [a, b, c] = tree.facet(f);
            least2 = std::min(least2, (closest_on_triangle(p, tree.point(a), tree.point(b), tree.point(c)) - p).squaredNorm());
        }
        const FacetTree::Hit hit = tree.closest(p, wanted, -1);
        EXPECT_DOUBLE_EQ(hit.distance2, least2);
        if (wanted != FacetTree::kAnyPatch && hit.facet >= 0) {
            EXPECT_EQ(tree.patch(hit.facet), wanted);
        }
    }
}

TEST(FacetTree, WhatFacesUpIsFoundWithinReachOnly) {
    // Two squares above each other, the upper one facing up, the lower one down.
    const std::vector<Point> points{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
    const FacetTree tree(points, triangles);
    const Point p(0.7, 0.2, 0.1);
    const auto facing = [&](double up, double reach) {
        return tree.closest_facing(p, FacetTree::kAnyPatch, up * Eigen::Vector3d::UnitZ(), reach);
    };
    EXPECT_EQ(facing(-1.0, 0.2).facet, 2);
    EXPECT_EQ(facing(1.0, 1.0).facet, 0);
    EXPECT_NEAR(facing(1.0, 1.0).distance2, 0.81, 1e-12);
    EXPECT_EQ(facing(1.0, 0.8).facet, -1);
}

}  // namespace
}  // namespace anisoquad
