#include "mesh/flip_check.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/arrays.h"
#include "mesh/euler_operators.h"

namespace anisoquad {
namespace {

/// Two triangles on the edge from (0,0,0) to (1,0,0), each turned down by half of the angle; their apexes at x = left and right.
Edge roof(SurfaceMesh& mesh, double half_angle, double left = 0.5, double right = 0.5) {
    const double y = std::cos(half_angle);
    const double z = -std::sin(half_angle);
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {left, y, z}, {right, -y, z}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
    mesh = from_arrays(points, triangles);
    return SurfaceMesh::edge(mesh.find_halfedge(Vertex(0), Vertex(1)));
}

TEST(FlipKeepsSurface, FlatPairsMayBeFlipped) {
    SurfaceMesh mesh;
    EXPECT_TRUE(flip_keeps_surface(mesh, roof(mesh, 0.0), 0.8));
}

TEST(FlipKeepsSurface, NoTriangleIsTurnedOver) {
    SurfaceMesh mesh;
    EXPECT_FALSE(flip_keeps_surface(mesh, roof(mesh, 0.0, 3.0, 3.0), 0.8));
}

/// Cosine between the two triangles at the edge.
double fold(const SurfaceMesh& mesh, Edge e) {
    const auto normal = [&](HalfEdge h) {
        const Point& a = mesh.position(mesh.from(h));
        return (mesh.position(mesh.to(h)) - a).cross(mesh.position(mesh.to(mesh.next(h))) - a).normalized().eval();
    };
    return normal(SurfaceMesh::halfedge(e, 0)).dot(normal(SurfaceMesh::halfedge(e, 1)));
}

TEST(FlipKeepsSurface, WhatPassesFoldsNoSharperThanAllowed) {
    int passed = 0;
    int refused = 0;
    for (int i = 1; i < 12; ++i) {
        for (int k = -4; k <= 4; ++k) {
            SurfaceMesh mesh;
            const Edge e = roof(mesh, 0.12 * i, 0.5 + 0.2 * k, 0.5 - 0.2 * k);
            const double before = fold(mesh, e);
            const bool may = flip_keeps_surface(mesh, e, 0.3);
            (may ? passed : refused) += 1;
            if (!may) continue;
            flip(mesh, e);
            EXPECT_GE(fold(mesh, e), std::min(0.3, before - 0.03));
        }
    }
    EXPECT_GT(passed, 0);
    EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace anisoquad
