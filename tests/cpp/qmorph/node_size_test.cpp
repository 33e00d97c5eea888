#include "qmorph/node_size.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

/// Ratio of the wanted size to the side of the square of two triangles, which all of these regular meshes share.
double density(const shapes::Shape& shape, double side) {
    SurfaceMesh mesh = shape.mesh();
    assign_node_sizes(mesh);
    const double first = mesh.info(Vertex(0)).size;
    for (const Vertex v : vertices(mesh)) EXPECT_NEAR(mesh.info(v).size, first, 1e-9 * first);
    return first / side;
}

TEST(NodeSize, IsAboutTheSideOfTheSquareOfTwoTriangles) {
    const double d = density(shapes::grid(5, 4), 1.0);
    EXPECT_GT(d, 0.85);
    EXPECT_LT(d, 1.1);
    for (const double scale : {1e-4, 250.0})
        EXPECT_NEAR(density(shapes::placed(shapes::grid(5, 4), scale, Point(3, 0, 0)), scale), d, 1e-9);
    EXPECT_NEAR(density(shapes::grid(5, 4, 2.0, 0.5), 1.0), d, 1e-9);
}

TEST(NodeSize, FollowsTheTrianglesAround) {
    shapes::Shape shape = shapes::grid(8, 2);
    for (Point& p : shape.points) p.x() = p.x() * p.x();  // cells get wider
    SurfaceMesh mesh = shape.mesh();
    assign_node_sizes(mesh);
    for (int i = 0; i < 8; ++i) EXPECT_LT(mesh.info(Vertex(9 + i)).size, mesh.info(Vertex(10 + i)).size);
}

TEST(NodeSize, NodesAmongQuadsAndIsolatedOnesKeepTheirs) {
    shapes::Shape shape = shapes::grid(2, 2);
    shape.points.emplace_back(9, 9, 9);
    SurfaceMesh mesh = shape.mesh();
    for (const Edge e : edges(mesh)) {
        const HalfEdge h = SurfaceMesh::halfedge(e);
        const Eigen::Vector3d d = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
        if (d.x() != 0.0 && d.y() != 0.0) dissolve_edge(mesh, e);
    }
    mesh.info(Vertex(4)).size = 0.25;
    assign_node_sizes(mesh);
    EXPECT_EQ(mesh.info(Vertex(4)).size, 0.25);
    EXPECT_EQ(mesh.info(Vertex(9)).size, 0.0);
}

}  // namespace
}  // namespace anisoquad
