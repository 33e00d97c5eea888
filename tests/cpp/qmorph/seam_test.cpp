#include "qmorph/seam.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

/// Two quads left and right of a gap at node 0, two more below, triangles above. `right` and `left` are the lengths of the gap's
/// sides 0 – 1 and 0 – 2, at `angle` degrees from each other.
Prepared gap(double angle, double right, double left) {
    shapes::Shape shape;
    const double a = 0.5 * angle * std::numbers::pi / 180.0;
    shape.points = {{0, 0, 0},
                    {right * std::sin(a), right * std::cos(a), 0},
                    {-left * std::sin(a), left * std::cos(a), 0},
                    {1, 0, 0},
                    {1.2, 1, 0},
                    {1.2, 2, 0},
                    {0, 2, 0},
                    {-1.2, 2, 0},
                    {-1.2, 1, 0},
                    {-1, 0, 0},
                    {-1, -1, 0},
                    {0, -1, 0},
                    {1, -1, 0}};
    shape.add_quad(0, 3, 4, 1);
    shape.add_quad(9, 0, 2, 8);
    shape.add_quad(10, 11, 0, 9);
    shape.add_quad(11, 12, 3, 0);
    shape.triangles.insert(shape.triangles.end(), {{0, 1, 2}, {1, 4, 5}, {1, 5, 6}, {1, 6, 2}, {2, 6, 7}, {2, 7, 8}});
    Prepared p(shape);
    for (const auto& [b, c] : {std::pair{0, 4}, {9, 2}, {10, 0}, {11, 3}}) {
        const HalfEdge diagonal = p.mesh.find_halfedge(Vertex(b), Vertex(c));
        dissolve_edge(p.mesh, M::edge(diagonal));
    }
    return p;
}

HalfEdge into_gap(const Prepared& p) { return p.mesh.find_halfedge(Vertex(2), Vertex(0)); }

/// Nothing but triangles and quads, none turned over.
void expect_good(const Prepared& p) {
    expect_sound(p);
    for (const Face f : faces(p.mesh)) {
        EXPECT_LE(p.mesh.valence(f), 4);
        EXPECT_GT(doubled_area(p.mesh, f).z(), 0.0);
    }
    EXPECT_NEAR(signed_area(p), input_area(p.shape), 1e-9);
}

TEST(Seam, TheAngleDecides) {
    EXPECT_EQ(classify_seam(gap(20, 1, 1).mesh, into_gap(gap(20, 1, 1))), SeamKind::seam);
    EXPECT_EQ(classify_seam(gap(50, 1, 1).mesh, into_gap(gap(50, 1, 1))), SeamKind::none);
}

TEST(Seam, TheTwoEdgesBecomeOne) {
    Prepared p = gap(20, 1, 1);
    ASSERT_TRUE(is_front(p.mesh, into_gap(p)));
    const int nodes = p.mesh.vertex_count();
    const Vertex merged = seam(p.mesh, into_gap(p));
    ASSERT_TRUE(merged.is_valid());
    EXPECT_EQ(p.mesh.vertex_count(), nodes - 1);
    EXPECT_EQ(quad_count(p.mesh), 4);
    EXPECT_EQ(triangle_count(p.mesh), 4);  // those beside the ridge are gone
    const HalfEdge h = p.mesh.find_halfedge(Vertex(0), merged);
    ASSERT_TRUE(h.is_valid());
    EXPECT_TRUE(p.mesh.is_quad(p.mesh.face(h)) && p.mesh.is_quad(p.mesh.face(M::twin(h))));
    EXPECT_LE(std::abs(p.mesh.position(merged).x()), std::sin(0.1746));
    expect_good(p);
}

TEST(Seam, TrianglesInTheGapVanishWithIt) {
    Prepared p = gap(20, 1, 1);
    const Face sliver = p.mesh.face(into_gap(p));
    split_face(p.mesh, sliver, Point(0.01, 0.6, 0.0));
    const Vertex merged = seam(p.mesh, into_gap(p));
    ASSERT_TRUE(merged.is_valid());
    EXPECT_EQ(triangle_count(p.mesh), 4);
    expect_good(p);
}

TEST(Seam, AFixedNodeKeepsItsPlace) {
    Prepared p = gap(20, 1, 1);
    p.mesh.info(Vertex(1)).kind = NodeKind::corner;
    const Point at = p.mesh.position(Vertex(1));
    ASSERT_EQ(classify_seam(p.mesh, into_gap(p)), SeamKind::seam);
    EXPECT_EQ(seam(p.mesh, into_gap(p)), Vertex(1));
    EXPECT_EQ(p.mesh.position(Vertex(1)), at);
    expect_good(p);
}

TEST(Seam, TwoFixedNodesAreNotMerged) {
    Prepared p = gap(20, 1, 1);
    p.mesh.info(Vertex(1)).kind = p.mesh.info(Vertex(2)).kind = NodeKind::corner;
    EXPECT_EQ(classify_seam(p.mesh, into_gap(p)), SeamKind::none);
    EXPECT_FALSE(seam(p.mesh, into_gap(p)).is_valid());
    expect_good(p);
    EXPECT_EQ(p.mesh.vertex_count(), 13);
}

TEST(Seam, UnequalEdgesGetATransition) {
    for (const bool right_longer : {false, true}) {
        Prepared p = right_longer ? gap(24, 1.2, 0.4) : gap(24, 0.4, 1.2);
        ASSERT_EQ(classify_seam(p.mesh, into_gap(p)), SeamKind::transition_seam);
        const Face f = transition_seam(p.mesh, into_gap(p));
        ASSERT_TRUE(f.is_valid());
        EXPECT_TRUE(p.mesh.is_quad(f));
        EXPECT_EQ(p.mesh.vertex_count(), 14);  // the middle of the longer edge
        bool at_node = false;
        for (const HalfEdge h : p.mesh.halfedges(f)) at_node = at_node || p.mesh.from(h) == Vertex(0);
        EXPECT_TRUE(at_node);
        EXPECT_EQ(quad_count(p.mesh), 5);
        expect_good(p);
    }
}

/// Two quads of the given height side by side under triangles, one three times as long as the other.
Prepared step(bool first_longer, double height) {
    shapes::Shape shape = shapes::grid(2, 2);
    for (Point& q : shape.points) {
        q.x() = q.x() == 0.0 ? (first_longer ? -1.0 : -0.3) : q.x() == 2.0 ? (first_longer ? 0.3 : 1.0) : 0.0;
        if (q.y() == 0.0) q.y() = 1.0 - height;
    }
    Prepared p(shape);
    for (const auto& [b, c] : {std::pair{0, 4}, {2, 4}})
        dissolve_edge(p.mesh, M::edge(p.mesh.find_halfedge(Vertex(b), Vertex(c))));
    return p;
}

TEST(Seam, AHighQuadIsNotHalvedSinceTheNotchWouldBeSeamedAgain) {
    for (const bool first_longer : {false, true}) {
        const Prepared p = step(first_longer, 1.0);
        EXPECT_EQ(classify_seam(p.mesh, p.mesh.find_halfedge(Vertex(3), Vertex(4))), SeamKind::none);
    }
}

TEST(Seam, ALongEdgeNextToAShortOneOnTheFrontIsHalved) {
    for (const bool first_longer : {false, true}) {
        Prepared p = step(first_longer, 0.4);
        const HalfEdge h = p.mesh.find_halfedge(Vertex(3), Vertex(4));
        ASSERT_TRUE(is_front(p.mesh, h));
        ASSERT_EQ(classify_seam(p.mesh, h), SeamKind::transition_split);
        const int triangles = triangle_count(p.mesh);
        const Vertex m = transition_split(p.mesh, h);
        ASSERT_TRUE(m.is_valid());
        EXPECT_NEAR(p.mesh.position(m).x(), first_longer ? -0.5 : 0.5, 1e-12);
        EXPECT_EQ(quad_count(p.mesh), 2);
        EXPECT_EQ(triangle_count(p.mesh), triangles + 2);  // one of the quad, one of the triangle before it
        expect_good(p);
    }
}

TEST(Seam, NothingIsHalvedWhereTheMiddleWouldBeJoinedToANodeTwice) {
    // The triangle in the gap 0 – 1 – 2 and the quad behind share both edges at node 1.
    shapes::Shape shape;
    shape.points = {{4, 0, 0}, {0, 0, 0}, {1, -0.1, 0}, {2, 3, 0}};
    shape.triangles = {{0, 1, 2}};
    shape.add_quad(1, 0, 3, 2);
    SurfaceMesh mesh = shape.mesh();
    dissolve_edge(mesh, M::edge(mesh.find_halfedge(Vertex(1), Vertex(3))));
    EXPECT_EQ(classify_seam(mesh, mesh.find_halfedge(Vertex(0), Vertex(1))), SeamKind::none);
}

TEST(Seam, RowsAndLinesAreNotHalved) {
    Prepared row = gap(24, 0.4, 1.2);
    row.mesh.info(row.mesh.face(M::twin(into_gap(row)))).row = 1;
    EXPECT_NE(classify_seam(row.mesh, into_gap(row)), SeamKind::transition_seam);
    EXPECT_FALSE(transition_seam(row.mesh, into_gap(row)).is_valid());
    EXPECT_FALSE(transition_split(row.mesh, into_gap(row)).is_valid());
    expect_good(row);
    Prepared line = gap(24, 0.4, 1.2);
    line.mesh.info(M::edge(into_gap(line))).line = 3;
    EXPECT_NE(classify_seam(line.mesh, into_gap(line)), SeamKind::transition_seam);
    EXPECT_FALSE(transition_seam(line.mesh, into_gap(line)).is_valid());
    expect_good(line);
}

}  // namespace
}  // namespace anisoquad
