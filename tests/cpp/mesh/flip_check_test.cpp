#include "mesh/flip_check.h"

#include <gtest/gtest.h>

#include "mesh/arrays.h"

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

TEST(FlipKeepsSurface, ARidgeIsNotCutThrough) {
    SurfaceMesh mesh;
    EXPECT_FALSE(flip_keeps_surface(mesh, roof(mesh, 1.2), 0.3));
}

}  // namespace
}  // namespace anisoquad
