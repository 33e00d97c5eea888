#include "picking/imprint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "errors.h"
#include "input/check.h"
#include "mesh/arrays.h"
#include "mesh/validate.h"
#include "picking/best_path.h"
#include "picking/picking_shapes.h"
#include "picking/zigzag.h"

namespace anisoquad {
namespace {

double smallest_angle(const ImprintResult& result) {
    double smallest = std::numbers::pi;
    for (const auto& t : result.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& p = result.points[static_cast<std::size_t>(t[k])];
            const Eigen::Vector3d a = result.points[static_cast<std::size_t>(t[(k + 1) % 3])] - p;
            const Eigen::Vector3d b = result.points[static_cast<std::size_t>(t[(k + 2) % 3])] - p;
            smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
    }
    return smallest;
}

double area(const std::vector<Point>& points, const std::vector<std::array<std::int32_t, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& t : triangles) {
        const auto at = [&](std::size_t k) -> const Point& { return points[static_cast<std::size_t>(t[k])]; };
        sum += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    return sum;
}

void expect_sound(const PickSurface& surface, const ImprintResult& result) {
    ASSERT_NO_THROW(check_input(result.points, result.triangles));
    const SurfaceMesh mesh = from_arrays(result.points, result.triangles);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(topology(mesh) == topology(surface.mesh));
    const Source source{result.path, {}, Sides::both};
    EXPECT_NO_THROW(check_sources(mesh, std::span(&source, 1)));
    for (std::size_t i = 0; i < surface.points.size(); ++i) EXPECT_EQ(result.points[i], surface.points[i]);
}

TEST(Imprint, MakesAZigzagOnAPlaneAStraightLine) {
    const PickSurface surface = shapes::pick_surface(shapes::unstructured(20));
    for (const auto& [from, to] :
         {std::pair(10 * 21 + 1, 13 * 21 + 19), std::pair(4 * 21 + 2, 16 * 21 + 15), std::pair(9 * 21 + 2, 9 * 21 + 18)}) {
        const std::vector<std::int32_t> path = best_path(surface, from, to);
        ASSERT_TRUE(is_zigzag(surface.mesh, shapes::vertices(path)));
        const ImprintResult result = imprint(surface, path);
        EXPECT_GE(result.pieces, 1);
        expect_sound(surface, result);
        EXPECT_EQ(result.path.front(), from);
        EXPECT_EQ(result.path.back(), to);
        const double straight =
            (surface.points[static_cast<std::size_t>(to)] - surface.points[static_cast<std::size_t>(from)]).norm();
        EXPECT_LT(shapes::length(result.points, result.path), 1.004 * straight);
        EXPECT_FALSE(is_zigzag(from_arrays(result.points, result.triangles), shapes::vertices(result.path)));
        EXPECT_GT(smallest_angle(result), 5.0 * std::numbers::pi / 180.0);
        EXPECT_NEAR(area(result.points, result.triangles), 400.0, 1e-6);
    }
}

TEST(Imprint, TheNodesHaveEvenDistances) {
    const PickSurface surface = shapes::pick_surface(shapes::unstructured(20));
    const ImprintResult result = imprint(surface, best_path(surface, 10 * 21 + 1, 13 * 21 + 19));
    double shortest = 1e9;
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
        const double step = shapes::length(result.points, {result.path[i], result.path[i + 1]});
        shortest = std::min(shortest, step);
        longest = std::max(longest, step);
    }
    EXPECT_LT(longest / shortest, 4.0);
}

TEST(Imprint, AStraightOrSmoothlyBentPathStaysAsItIs) {
    const PickSurface grid = shapes::pick_surface(shapes::grid(12, 10));
    const std::vector<std::int32_t> path = best_path(grid, 5 * 13 + 2, 5 * 13 + 9);
    const ImprintResult result = imprint(grid, path);
    EXPECT_EQ(result.pieces, 0);
    EXPECT_EQ(result.path, path);
    EXPECT_EQ(result.triangles, grid.triangles);
    const int n = 30;
    const PickSurface cylinder = shapes::pick_surface(shapes::cylinder(n, 6));
    std::vector<std::int32_t> ring;
    for (int i = 0; i <= n; ++i) ring.push_back(3 * n + i % n);
    EXPECT_EQ(imprint(cylinder, ring).pieces, 0);
}

TEST(Imprint, OtherLinesAreKept) {
    const shapes::Shape shape = shapes::unstructured(20);
    const PickSurface free = shapes::pick_surface(shape);
    const std::vector<std::int32_t> other = best_path(free, 5 * 21 + 1, 5 * 21 + 19);
    std::vector<std::array<std::int32_t, 2>> kept;
    for (std::size_t i = 0; i + 1 < other.size(); ++i) kept.push_back({other[i], other[i + 1]});
    const PickSurface surface = shapes::pick_surface(shape, 40.0, kept);
    const ImprintResult result = imprint(surface, best_path(free, 8 * 21 + 1, 7 * 21 + 19));
    EXPECT_GE(result.pieces, 1);
    expect_sound(surface, result);
    const SurfaceMesh mesh = from_arrays(result.points, result.triangles);
    for (const auto& [a, b] : kept) EXPECT_TRUE(mesh.find_halfedge(Vertex(a), Vertex(b)).is_valid());
}

TEST(Imprint, IsTheSameWhateverTheSizeOfTheModel) {
    const shapes::Shape shape = shapes::unstructured(16);
    const PickSurface surface = shapes::pick_surface(shape);
    const PickSurface small = shapes::pick_surface(shapes::placed(shape, 1.0 / 1024, Point::Zero()));
    const std::vector<std::int32_t> path = best_path(surface, 7 * 17 + 1, 9 * 17 + 15);
    EXPECT_EQ(imprint(surface, path).triangles, imprint(small, path).triangles);
}

TEST(Imprint, WhatIsNoPathIsRefused) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(6, 6));
    EXPECT_THROW(imprint(surface, std::vector<std::int32_t>{0, 9}), Error);
}

}  // namespace
}  // namespace anisoquad
