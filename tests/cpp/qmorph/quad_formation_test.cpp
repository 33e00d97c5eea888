#include "qmorph/quad_formation.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "qmorph/node_size.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

HalfEdge edge(const SurfaceMesh& mesh, int a, int b) { return mesh.find_halfedge(Vertex(a), Vertex(b)); }

TEST(QuadFormation, TheTrianglesBetweenTheFourEdgesBecomeOneQuad) {
    Prepared p(shapes::grid(3, 3));
    const Face f = form_quad(p.mesh, edge(p.mesh, 0, 1), Vertex(5), Vertex(4));
    ASSERT_TRUE(f.is_valid());
    EXPECT_TRUE(p.mesh.is_quad(f));
    EXPECT_EQ(p.mesh.face(edge(p.mesh, 0, 1)), f);
    EXPECT_EQ(p.mesh.face(edge(p.mesh, 5, 4)), f);
    EXPECT_EQ(p.mesh.info(f).patch, 0);
    EXPECT_EQ(triangle_count(p.mesh), 16);
    expect_sound(p);
}

TEST(QuadFormation, NodesInsideAreRemoved) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0.7, 0.8, 0}, {1.4, 1.2, 0}};
    shape.triangles = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}};
    Prepared p(shape);
    const Face f = form_quad(p.mesh, edge(p.mesh, 0, 1), Vertex(2), Vertex(3));
    ASSERT_TRUE(f.is_valid());
    EXPECT_EQ(p.mesh.vertex_count(), 4);
    EXPECT_EQ(p.mesh.face_count(), 1);
    EXPECT_NEAR(doubled_area(p.mesh, f).z(), 8.0, 1e-12);
    expect_sound(p);
}

TEST(QuadFormation, NothingChangesWhereItCanNotBeMade) {
    Prepared p(shapes::grid(3, 3));
    const auto refused = [&](Vertex c, Vertex d) {
        const int faces_before = p.mesh.face_count();
        const int vertices_before = p.mesh.vertex_count();
        EXPECT_FALSE(form_quad(p.mesh, edge(p.mesh, 0, 1), c, d).is_valid());
        EXPECT_EQ(p.mesh.face_count(), faces_before);
        EXPECT_EQ(p.mesh.vertex_count(), vertices_before);
        expect_sound(p);
    };
    refused(Vertex(10), Vertex(4));  // no edge 1 – 10
    refused(Vertex(5), Vertex(8));   // no edge 5 – 8
    // A line or a quad inside.
    p.mesh.info(SurfaceMesh::edge(edge(p.mesh, 0, 5))).line = 7;
    refused(Vertex(5), Vertex(4));
    p.mesh.info(SurfaceMesh::edge(edge(p.mesh, 0, 5))).line = -1;
    dissolve_edge(p.mesh, SurfaceMesh::edge(edge(p.mesh, 0, 5)));
    refused(Vertex(5), Vertex(4));
}

TEST(QuadFormation, AFoldedQuadIsRefusedUnlessItIsAskedFor) {
    shapes::Shape shape;  // a dart: node 2 is reflex
    shape.points = {{0, 1, 0}, {-1, -1, 0}, {0, 0.5, 0}, {1, -1, 0}};
    shape.triangles = {{0, 1, 2}, {0, 2, 3}};
    Prepared p(shape);
    EXPECT_FALSE(form_quad(p.mesh, edge(p.mesh, 0, 1), Vertex(2), Vertex(3)).is_valid());
    EXPECT_EQ(triangle_count(p.mesh), 2);
    EXPECT_TRUE(form_quad(p.mesh, edge(p.mesh, 0, 1), Vertex(2), Vertex(3), -1.0).is_valid());
    expect_sound(p);
}

TEST(QuadFormation, SmoothingKeepsLinesAndTurnsNothingOver) {
    for (const auto& shape : {shapes::grid(6, 6), shapes::cylinder(24, 6)}) {
        Prepared p(shape);
        const int stride = shape.points.size() == 49 ? 7 : 24;
        // The new quad's upper nodes are pulled aside, short of folding anything.
        const Point pulled = p.mesh.position(Vertex(2 + stride)) +
                             0.3 * (p.mesh.position(Vertex(3 + stride)) - p.mesh.position(Vertex(2 + stride)));
        p.mesh.position(Vertex(2 + stride)) = pulled;
        const Face f = form_quad(p.mesh, edge(p.mesh, 2, 3), Vertex(3 + stride), Vertex(2 + stride));
        ASSERT_TRUE(f.is_valid());
        assign_node_sizes(p.mesh);
        const double before = scaled_jacobian(p.mesh, f);
        FacetHints hints;
        smooth_around(p.mesh, f, &p.reference, hints);
        EXPECT_GE(scaled_jacobian(p.mesh, f), before - 1e-3);
        // Isoparametric: opposite sides become alike.
        const auto top = p.mesh.length(edge(p.mesh, 3 + stride, 2 + stride));
        EXPECT_NEAR(top / p.mesh.length(edge(p.mesh, 2, 3)), 1.0, 0.05);
        EXPECT_EQ(inverted_triangles(p), 0);
        for (const Vertex v : vertices(p.mesh)) {
            if (p.mesh.info(v).kind == NodeKind::interior) continue;
            EXPECT_EQ(p.mesh.position(v), shape.points[static_cast<std::size_t>(v.index())]);
        }
        // Only the quad and the ring round it move.
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(p.mesh.position(Vertex(i + 4 * stride)), shape.points[static_cast<std::size_t>(i + 4 * stride)]);
    }
}

}  // namespace
}  // namespace anisoquad
