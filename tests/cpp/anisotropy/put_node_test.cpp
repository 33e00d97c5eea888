#include "anisotropy/put_node.h"

#include <gtest/gtest.h>

#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

/// The end of a trace at a place of the plane.
TraceEnd end_at(const SurfaceMesh& mesh, double x, double y) {
    TraceEnd end;
    end.position = Point(x, y, 0.0);
    for (const Face f : faces(mesh)) {
        bool inside = true;
        for (const HalfEdge h : mesh.halfedges(f)) {
            const Point& a = mesh.position(mesh.from(h));
            inside &= (mesh.position(mesh.to(h)) - a).cross(end.position - a).z() >= 0.0;
        }
        if (inside) end.face = f;
    }
    return end;
}

struct PutNode : testing::Test {
    Prepared p{shapes::grid(4, 4)};

    void expect_node_at(Vertex v, double x, double y) const {
        EXPECT_NEAR((p.mesh.position(v) - Point(x, y, 0.0)).norm(), 0.0, 1e-12);
        expect_sound(p);
    }
};

TEST_F(PutNode, MovesAFreeNodeCloseBy) {
    const std::int32_t faces = p.mesh.face_count();
    const Vertex v = put_node(p.mesh, end_at(p.mesh, 2.1, 1.9), 0.3);
    EXPECT_EQ(v, Vertex(12));
    EXPECT_EQ(p.mesh.info(v).input, -1);
    EXPECT_EQ(p.mesh.face_count(), faces);
    expect_node_at(v, 2.1, 1.9);
}

TEST_F(PutNode, SplitsAnEdgeCloseBy) {
    const std::int32_t faces = p.mesh.face_count();
    const Vertex v = put_node(p.mesh, end_at(p.mesh, 2.5, 2.04), 0.3);
    EXPECT_EQ(p.mesh.face_count(), faces + 2);
    EXPECT_EQ(p.mesh.valence(v), 4);
    expect_node_at(v, 2.5, 2.04);
}

TEST_F(PutNode, SplitsTheTriangleElsewhere) {
    const std::int32_t faces = p.mesh.face_count();
    const Vertex v = put_node(p.mesh, end_at(p.mesh, 2.6, 2.3), 0.1);
    EXPECT_EQ(p.mesh.face_count(), faces + 2);
    EXPECT_EQ(p.mesh.valence(v), 3);
    expect_node_at(v, 2.6, 2.3);
}

TEST_F(PutNode, LeavesNodesOfLinesAndRows) {
    p.mesh.info(Vertex(12)).in_row = true;
    EXPECT_NE(put_node(p.mesh, end_at(p.mesh, 2.1, 1.9), 0.3), Vertex(12));
    EXPECT_NE(put_node(p.mesh, end_at(p.mesh, 2.1, 0.05), 0.3), Vertex(2));
    expect_sound(p);
}

/// Round a node whose move would turn a triangle over, the triangle is split instead.
TEST_F(PutNode, TurnsNoTriangleOver) {
    p.mesh.position(Vertex(12)) = Point(1.2, 1.9, 0.0);
    const Vertex v = put_node(p.mesh, end_at(p.mesh, 2.7, 2.6), 5.0);
    EXPECT_NE(v, Vertex(12));
    expect_sound(p);
}

}  // namespace
}  // namespace anisoquad
