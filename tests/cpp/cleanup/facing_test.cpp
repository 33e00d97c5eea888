#include "cleanup/facing.h"

#include <gtest/gtest.h>

#include "cleanup/quad_shapes.h"

namespace anisoquad {
namespace {

Face face_between(const SurfaceMesh& mesh, std::int32_t a, std::int32_t b) {
    return mesh.face(mesh.find_halfedge(Vertex(a), Vertex(b)));
}

TEST(Facing, AQuadThatIsTurnedOverIsOutvoted) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    mesh.position(Vertex(6)) = Point(2.5, 2.5, 0.0);  // the node (1, 1)
    const Face turned = face_between(mesh, 6, 7);
    ASSERT_LT(doubled_area_vector_of_quad(mesh, turned).z(), 0.0);
    EXPECT_GT(facing(mesh, turned).z(), 0.0);
}

TEST(Facing, WhatLiesBehindALineDoesNotCount) {
    // Two sheets that meet at the line x = 2 at 0°: the right one is folded back under the left one.
    SurfaceMesh mesh = shapes::quad_grid(4, 2);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        Point& p = mesh.position(Vertex(i));
        if (p.x() > 2.0) p = Point(4.0 - p.x(), p.y(), -1e-3 * (p.x() - 2.0));
    }
    for (const std::int32_t v : {2, 7}) mesh.info(SurfaceMesh::edge(mesh.find_halfedge(Vertex(v), Vertex(v + 5)))).line = 1;
    EXPECT_GT(facing(mesh, face_between(mesh, 1, 2)).z(), 0.0);
    EXPECT_LT(facing(mesh, face_between(mesh, 2, 3)).z(), 0.0);
}

TEST(Facing, OfASectorEndsAtTheEdgeThatIsNamed) {
    const SurfaceMesh mesh = shapes::quad_grid(4, 4);
    const HalfEdge start = mesh.find_halfedge(Vertex(12), Vertex(13));
    const HalfEdge last = mesh.find_halfedge(Vertex(12), Vertex(11));
    const auto is_last = [&](Edge e) { return e == SurfaceMesh::edge(last); };
    EXPECT_DOUBLE_EQ(facing(mesh, start, is_last).z(), 4.0);                     // two quads, twice their area
    EXPECT_DOUBLE_EQ(facing(mesh, start, [](Edge) { return false; }).z(), 8.0);  // once round
}

}  // namespace
}  // namespace anisoquad
