#include "mesh/validate.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/euler_operators.h"
#include "shapes.h"

namespace anisoquad {
namespace {

TEST(Validate, FindsBrokenLinks) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    ASSERT_TRUE(validate(mesh).empty());
    const HalfEdge h = mesh.halfedge(Face(0));
    mesh.link(h, mesh.next(mesh.next(h)));
    EXPECT_FALSE(validate(mesh).empty());
}

TEST(Validate, FindsAFaceWithMoreThanFourNodes) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    insert_vertex(mesh, SurfaceMesh::edge(mesh.halfedge(Face(0))), {0.1, 0.1, 0.0});
    EXPECT_TRUE(validate(mesh).empty());  // quads
    insert_vertex(mesh, SurfaceMesh::edge(mesh.halfedge(Face(0))), {0.2, 0.2, 0.0});
    EXPECT_FALSE(validate(mesh).empty());
}

TEST(Validate, FindsAWrongOutgoingHalfEdge) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    mesh.set_halfedge(Vertex(0), mesh.rotated_cw(mesh.halfedge(Vertex(0))));
    EXPECT_FALSE(validate(mesh).empty());
}

TEST(Validate, FindsTwoEdgesBetweenTheSameNodes) {
    SurfaceMesh mesh = shapes::torus(4, 4).mesh();
    Edge e;
    for (std::int32_t i = 0; i < mesh.edge_slots() && !e.is_valid(); ++i) {  // an edge whose other diagonal exists elsewhere
        const HalfEdge h = SurfaceMesh::halfedge(Edge(i));
        const Vertex a = mesh.from(mesh.prev(h));
        const Vertex b = mesh.from(mesh.prev(SurfaceMesh::twin(h)));
        if (a != b && mesh.find_halfedge(a, b).is_valid()) e = Edge(i);
    }
    if (!e.is_valid()) {
        mesh = shapes::Shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}.mesh();
        e = Edge(0);
    }
    ASSERT_TRUE(validate(mesh).empty());
    flip(mesh, e);
    EXPECT_FALSE(validate(mesh).empty());
}

TEST(Validate, FindsAPositionThatIsNotFinite) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    mesh.position(Vertex(4)).x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(validate(mesh).size(), 1u);
}

TEST(Validate, GivesAtMostTheLinesAskedFor) {
    SurfaceMesh mesh = shapes::grid(9, 9).mesh();
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i)
        mesh.position(Vertex(i)).x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(validate(mesh, 5).size(), 5u);
}

}  // namespace
}  // namespace anisoquad
