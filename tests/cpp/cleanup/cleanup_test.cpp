#include "cleanup/cleanup.h"

#include <gtest/gtest.h>

#include <set>

#include "cleanup/patterns.h"
#include "cleanup/quad_shapes.h"
#include "cleanup/sectors.h"
#include "quality/metrics.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// Makes the proposal, whatever it costs.
void apply(SurfaceMesh& mesh, const Proposal& proposal) {
    RegionEditor editor(mesh);
    Region region{proposal.faces, {}, {}};
    ASSERT_TRUE(editor.find_outline(region));
    ASSERT_TRUE(editor.is_possible(region, proposal.replacement));
    editor.replace(region, proposal.replacement);
}

std::vector<Point> positions(const SurfaceMesh& mesh, bool boundary_only) {
    std::vector<Point> points;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (!mesh.is_deleted(v) && (!boundary_only || mesh.is_boundary(v))) points.push_back(mesh.position(v));
    }
    return points;
}

double worst(const SurfaceMesh& mesh) {
    double q = 1.0;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (!mesh.is_deleted(Face(i))) q = std::min(q, scaled_jacobian(mesh, Face(i), Eigen::Vector3d::UnitZ()));
    }
    return q;
}

/// clean_up() must make the grid regular again, leave its boundary, and keep everything that clean_up() must keep.
void expect_regular_again(SurfaceMesh mesh, double nx, double ny) {
    ASSERT_EQ(shapes::defects(mesh), "");
    const Topology before = topology(mesh);
    const std::vector<Point> boundary = positions(mesh, true);
    ASSERT_GT(shapes::irregular_inside(mesh), 0);
    const CleanupResult result = clean_up(mesh, shapes::plane(nx, ny));
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_EQ(topology(mesh), before);
    EXPECT_EQ(positions(mesh, true), boundary);
    EXPECT_EQ(shapes::irregular_inside(mesh), 0);
    EXPECT_EQ(result.irregular_after, 0);
    EXPECT_GT(result.operations, 0);
    EXPECT_GT(worst(mesh), 0.8);
}

TEST(Cleanup, ARegularGridIsLeftAlone) {
    SurfaceMesh mesh = shapes::quad_grid(6, 5);
    const std::vector<Point> before = positions(mesh, false);
    const CleanupResult result = clean_up(mesh, shapes::plane(6, 5));
    EXPECT_EQ(result.operations, 0);
    EXPECT_EQ(positions(mesh, false), before);
}

TEST(Cleanup, TurnedEdgeIsTurnedBack) {
    SurfaceMesh mesh = shapes::quad_grid(6, 6);
    std::vector<Proposal> proposals;
    propose_edge_rotation(mesh, Vertex(24), proposals);
    ASSERT_EQ(proposals.size(), 2U * (4U + 8U));
    apply(mesh, proposals[0]);
    expect_regular_again(mesh, 6, 6);
}

TEST(Cleanup, CollapsedQuadIsOpened) {
    SurfaceMesh mesh = shapes::quad_grid(6, 6);
    std::vector<Proposal> proposals;
    propose_face_collapse(mesh, Vertex(24), proposals);
    ASSERT_EQ(proposals.size(), 4U);
    apply(mesh, proposals[0]);
    expect_regular_again(mesh, 6, 6);
}

TEST(Cleanup, OpenedNodeIsCollapsed) {
    SurfaceMesh mesh = shapes::quad_grid(6, 6);
    std::vector<Proposal> proposals;
    propose_vertex_split(mesh, Vertex(24), proposals);
    ASSERT_EQ(proposals.size(), 2U);
    apply(mesh, proposals[0]);
    expect_regular_again(mesh, 6, 6);
}

TEST(Cleanup, NodeInAHexagonIsRemoved) {
    SurfaceMesh mesh = shapes::quad_grid(6, 6);
    std::vector<Proposal> proposals;
    propose_hexagon(mesh, Vertex(24), proposals);
    ASSERT_EQ(proposals.size(), 2U * 4U);
    for (const Proposal& p : proposals) EXPECT_EQ(p.replacement.quads.size(), 3U);
    apply(mesh, proposals[0]);
    expect_regular_again(mesh, 6, 6);
}

TEST(Cleanup, DoubletIsDissolved) {
    SurfaceMesh mesh = shapes::quad_grid(6, 6);
    // A quad with a node inside that is joined to two opposite corners.
    const HalfEdge h = mesh.find_halfedge(Vertex(16), Vertex(17));
    RegionEditor editor(mesh);
    Region region{{mesh.face(h)}, {}, {}};
    ASSERT_TRUE(editor.find_outline(region));
    Replacement doublet;
    doublet.nodes.push_back({{2.5, 2.5, 0.0}, {}});
    const Vertex inside = Replacement::new_node(0);
    doublet.quads = {{Vertex(16), Vertex(17), Vertex(24), inside}, {Vertex(24), Vertex(23), Vertex(16), inside}};
    ASSERT_TRUE(editor.is_possible(region, doublet));
    editor.replace(region, doublet);
    expect_regular_again(mesh, 6, 6);
}

TEST(Cleanup, AQuadWithAFlatCornerOnALineIsRepaired) {
    // Quad 0 has two edges on the straight lower side: node 1 lies flat between nodes 0 and 2.
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    SurfaceMesh mesh = shapes::quad_mesh(points, {{0, 1, 2, 3}, {3, 2, 4, 5}});
    // The third side of the picture is a triangle 0 3 5 outside of the mesh: its edges are boundary.
    ASSERT_LT(worst(mesh), 0.01);
    const ReferenceSurface reference = shapes::plane(2.0, 2.0);
    clean_up(mesh, reference);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_GT(worst(mesh), 0.05);
}

TEST(Cleanup, BetweenLinesThatTheirEdgesMissNewNodesStayInTheMesh) {
    // A wedge that is bent aside by more than it is wide: its surface lies beside the quad whose edges are the lines' chords.
    SurfaceMesh mesh = shapes::quad_mesh({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 0.002, 0}}, {{0, 1, 2, 3}});
    const std::vector<Point> points{{0, 0, 0}, {0.33, -0.0014, 0}, {0.33, -0.0012, 0}, {0.67, -0.0014, 0}, {0.67, -0.001, 0},
                                    {1, 0, 0}, {1, 0.002, 0},      {0, -1, 0},         {1, -1, 0}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {1, 3, 4}, {1, 4, 2}, {3, 5, 6}, {3, 6, 4}, {7, 8, 5}};
    const ReferenceSurface bent(points, triangles, std::vector<std::int32_t>{0, 0, 0, 0, 0, 1});
    const std::vector<Point> boundary = positions(mesh, true);
    EXPECT_GT(clean_up(mesh, bent).operations, 0);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_EQ(positions(mesh, true), boundary);
    EXPECT_GT(worst(mesh), 1e-4);
}

TEST(Cleanup, AQuadWithAnAlmostFlatCornerIsWorthIrregularNodes) {
    for (const double rise : {0.06, 0.145}) {
        // A patch of one quad, at whose node 1 the outline hardly turns.
        SurfaceMesh mesh = shapes::quad_mesh({{0, rise, 0}, {1, 0, 0}, {2, rise, 0}, {1, 1.75, 0}}, {{0, 1, 2, 3}});
        const double before = worst(mesh);
        ASSERT_GT(before, 0.1);
        ASSERT_LT(before, 0.3);
        clean_up(mesh, shapes::plane(2.0, 2.0));
        EXPECT_EQ(shapes::defects(mesh), "");
        EXPECT_GT(worst(mesh), before + 0.1);
    }
}

TEST(Cleanup, AnInsetGivesEveryCornerOneQuadMore) {
    SurfaceMesh mesh = shapes::quad_grid(1, 1);
    std::vector<Proposal> proposals;
    propose_inset(mesh, Face(0), proposals);
    ASSERT_EQ(proposals.size(), 1U);
    apply(mesh, proposals[0]);
    EXPECT_EQ(mesh.face_count(), 5);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_GT(worst(mesh), 0.5);
    for (std::int32_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.valence(Vertex(i)), 3);
}

TEST(Cleanup, AnInsetOfTwoQuadsHasARingOfSix) {
    SurfaceMesh mesh = shapes::quad_grid(2, 1);
    std::vector<Proposal> proposals;
    propose_inset(mesh, Face(0), proposals);
    ASSERT_EQ(proposals.size(), 2U);
    apply(mesh, proposals[1]);
    EXPECT_EQ(mesh.face_count(), 8);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_GT(worst(mesh), 0.3);
}

TEST(Cleanup, PairsFarApartMeet) {
    // Two edges turned in opposite senses, some way apart: each leaves 3- and 5-valent nodes.
    SurfaceMesh mesh = shapes::quad_grid(12, 8);
    for (const auto& [node, which] : {std::pair{13 * 3 + 3, std::size_t{0}}, {13 * 5 + 9, std::size_t{1}}}) {
        std::vector<Proposal> proposals;
        propose_edge_rotation(mesh, Vertex(node), proposals);
        apply(mesh, proposals[which]);
    }
    expect_regular_again(mesh, 12, 8);
}

TEST(Cleanup, RowsAndLinesStay) {
    SurfaceMesh mesh = shapes::quad_grid(8, 8);
    std::vector<Proposal> proposals;
    propose_edge_rotation(mesh, Vertex(9 * 4 + 4), proposals);
    apply(mesh, proposals[0]);
    // The two turned quads become a row: their irregular nodes must stay as they are.
    std::set<Face> row{proposals[0].faces.begin(), proposals[0].faces.end()};
    for (const Face f : row) {
        mesh.info(f).row = 1;
        for (const HalfEdge h : mesh.halfedges(f)) mesh.info(mesh.from(h)).in_row = true;
    }
    const auto nodes_of_row = [&] {
        std::vector<Vertex> nodes;
        for (const Face f : row) {
            for (const HalfEdge h : mesh.halfedges(f)) nodes.push_back(mesh.from(h));
        }
        return nodes;
    };
    const std::vector<Vertex> before = nodes_of_row();
    clean_up(mesh, shapes::plane(8, 8));
    for (const Face f : row) {
        ASSERT_FALSE(mesh.is_deleted(f));
        EXPECT_EQ(mesh.info(f).row, 1);
    }
    EXPECT_EQ(nodes_of_row(), before);
    EXPECT_EQ(shapes::defects(mesh), "");
}

/// A grid with many random patterns, none of which touches the boundary.
SurfaceMesh disturbed_grid(int n, unsigned seed) {
    SurfaceMesh mesh = shapes::quad_grid(n, n);
    RegionEditor editor(mesh);
    unsigned state = seed;
    const auto random = [&] { return (state = state * 1664525U + 1013904223U) >> 8U; };
    for (int k = 0; k < 3 * n; ++k) {
        const Vertex v(static_cast<std::int32_t>(random() % static_cast<unsigned>(mesh.vertex_slots())));
        if (mesh.is_deleted(v)) continue;
        std::vector<Proposal> proposals;
        switch (random() % 3) {
            case 0: propose_face_collapse(mesh, v, proposals); break;
            case 1: propose_edge_rotation(mesh, v, proposals); break;
            default: propose_vertex_split(mesh, v, proposals); break;
        }
        if (proposals.empty()) continue;
        const Proposal& p = proposals[random() % proposals.size()];
        Region region{p.faces, {}, {}};
        if (editor.find_outline(region) && editor.is_possible(region, p.replacement)) editor.replace(region, p.replacement);
    }
    return mesh;
}

int total_cost(const SurfaceMesh& mesh, const Sectors& sectors) {
    int sum = 0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (!mesh.is_deleted(v) && mesh.halfedge(v).is_valid()) sum += sectors.cost(mesh, v);
    }
    return sum;
}

TEST(Cleanup, NeverMoreIrregularAlwaysValidAndTheSameTwice) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const ReferenceSurface reference = shapes::plane(16, 16);
        SurfaceMesh mesh = disturbed_grid(16, seed);
        ASSERT_EQ(shapes::defects(mesh), "");
        const Topology before = topology(mesh);
        const Sectors sectors(mesh, reference);
        const int cost = total_cost(mesh, sectors);
        SurfaceMesh again = mesh;
        clean_up(mesh, reference);
        EXPECT_EQ(shapes::defects(mesh), "");
        EXPECT_EQ(topology(mesh), before);
        EXPECT_LE(total_cost(mesh, sectors), cost);
        clean_up(again, reference);
        EXPECT_EQ(positions(mesh, false), positions(again, false));
    }
}

TEST(Sectors, IdealFollowsTheAngle) {
    const SurfaceMesh mesh = shapes::quad_grid(4, 3);
    const Sectors sectors(mesh, shapes::plane(4, 3));
    const auto count = [&](int from, int to) { return sectors.count(mesh, mesh.find_halfedge(Vertex(from), Vertex(to))); };
    EXPECT_EQ(count(0, 1).ideal, 1);
    EXPECT_EQ(count(0, 1).quads, 1);
    EXPECT_EQ(count(2, 3).ideal, 2);
    EXPECT_EQ(count(2, 3).quads, 2);
    EXPECT_EQ(count(6, 7).ideal, 4);
    EXPECT_EQ(count(6, 7).quads, 4);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) EXPECT_EQ(sectors.cost(mesh, Vertex(i)), 0);
}

}  // namespace
}  // namespace anisoquad
