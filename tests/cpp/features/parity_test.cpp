#include "features/parity.h"

#include <gtest/gtest.h>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/euler_operators.h"
#include "mesh/quad_chord.h"
#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

Source source(std::vector<std::int32_t> vertices) { return {std::move(vertices), {}, Sides::both}; }

/// Mesh with its features and patches found.
SurfaceMesh prepared(const shapes::Shape& shape, const std::vector<Source>& sources = {}, const Options& options = {}) {
    SurfaceMesh mesh = shape.mesh();
    find_features(mesh, sources, options);
    find_patches(mesh);
    return mesh;
}

/// Makes the mesh even and checks all that must hold, whatever the mesh.
ParityResult expect_even(SurfaceMesh& mesh) {
    const Topology before = topology(mesh);
    const std::int32_t odd = count_odd_components(mesh);
    const std::int32_t vertices = mesh.vertex_count();
    const ParityResult result = make_parity_even(mesh);
    EXPECT_EQ(result.odd, odd);
    EXPECT_EQ(count_odd_components(mesh), static_cast<std::int32_t>(result.left.size()));
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(topology(mesh) == before);
    EXPECT_EQ(mesh.vertex_count(), vertices + result.splits);
    EXPECT_EQ(static_cast<std::int32_t>(result.new_nodes.size()), result.splits);
    for (const Vertex v : result.new_nodes) {
        EXPECT_EQ(mesh.info(v).kind, NodeKind::line);
        EXPECT_GE(mesh.info(v).line, 0);
    }
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) EXPECT_GE(mesh.info(Face(i)).patch, 0);
    return result;
}

TEST(Parity, AnEvenMeshStaysAsItIs) {
    for (const auto& shape : {shapes::grid(5, 4), shapes::cube(3), shapes::sphere(24, 16), shapes::torus(40, 20)}) {
        SurfaceMesh mesh = prepared(shape);
        EXPECT_EQ(expect_even(mesh).splits, 0);
    }
}

TEST(Parity, AnOddPlaneIsSplitOnceAtItsLongestEdge) {
    shapes::Shape shape = shapes::grid(4, 4);
    shape.triangles.erase(shape.triangles.begin());  // the boundary edge 0–1, 1–6 becomes 0–6
    shape.points[24] += Point(0.6, 0.0, 0.0);        // stretches 23–24 to 1.6, beside 24–19 (1.17) and 22–23 (1)
    SurfaceMesh mesh = prepared(shape);
    ASSERT_EQ(count_odd_components(mesh), 1);
    const ParityResult result = expect_even(mesh);
    ASSERT_EQ(result.splits, 1);
    EXPECT_TRUE(mesh.position(result.new_nodes[0]).isApprox(0.5 * (shape.points[23] + shape.points[24])));
}

/// 3 + 2·2 + 3 edges a half when cut in the middle (8, 9, 10, 11); a triangle less at either outer corner makes both odd.
shapes::Shape two_odd_halves() {
    shapes::Shape shape = shapes::grid(3, 4);
    shape.triangles.erase(shape.triangles.begin());
    shape.triangles.pop_back();
    return shape;
}

TEST(Parity, OneSplitServesTwoPatchesThatShareACurve) {
    Options options;
    options.feature_edges = {{8, 9}, {9, 10}, {10, 11}};
    SurfaceMesh mesh = prepared(two_odd_halves(), {}, options);
    ASSERT_EQ(count_odd_components(mesh), 2);
    const ParityResult result = expect_even(mesh);
    EXPECT_EQ(result.splits, 1);
    EXPECT_NEAR(mesh.position(result.new_nodes[0]).y(), 2.0, 1e-12);
}

TEST(Parity, SourcesAreSpared) {
    SurfaceMesh mesh = prepared(two_odd_halves(), {source({8, 9, 10, 11})});
    const ParityResult result = expect_even(mesh);
    EXPECT_EQ(result.splits, 2);
    for (const Vertex v : result.new_nodes) EXPECT_GT(std::abs(mesh.position(v).y() - 2.0), 0.1);
}

TEST(Parity, ASourceIsSplitWhenNothingElseHelps) {
    const shapes::Shape shape = shapes::torus(24, 12);
    std::vector<Source> rings;
    for (const int j : {0, 6}) {
        std::vector<std::int32_t> ring;
        for (int i = 0; i <= 24; ++i) ring.push_back(j * 24 + i % 24);
        rings.push_back(source(ring));
    }
    SurfaceMesh mesh = prepared(shape, rings);
    const HalfEdge h = mesh.find_halfedge(Vertex(0), Vertex(1));
    split_edge(mesh, M::edge(h), 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    EXPECT_EQ(expect_even(mesh).splits, 1);
}

TEST(Parity, AColumnOfQuadsIsHalvedWhenItAloneJoinsTwoOddPatches) {
    // Two rings of quads round a torus, and triangles between them.
    SurfaceMesh mesh = prepared(shapes::torus(16, 12));
    for (const std::int32_t row : {0, 6}) {
        for (std::int32_t f = 32 * row; f < 32 * row + 32; f += 2) {
            for (const HalfEdge h : mesh.halfedges(Face(f))) {
                if (mesh.face(M::twin(h)) != Face(f + 1)) continue;
                dissolve_edge(mesh, M::edge(h));
                break;
            }
        }
    }
    ASSERT_EQ(count_odd_components(mesh), 0);
    HalfEdge top = mesh.find_halfedge(Vertex(16), Vertex(17));
    if (!mesh.is_triangle(mesh.face(top))) top = M::twin(top);
    std::vector<Vertex> nodes;
    split_chord(mesh, top, nodes);  // one edge more on either side
    ASSERT_EQ(nodes.size(), 2u);
    ASSERT_EQ(count_odd_components(mesh), 2);
    EXPECT_EQ(make_parity_even(mesh).splits, 2);
    EXPECT_EQ(count_odd_components(mesh), 0);
    EXPECT_TRUE(validate(mesh).empty());
}

TEST(Parity, BoundaryLoopsOfAnAnnulusCountTogether) {
    SurfaceMesh odd_twice = prepared(shapes::cylinder(15, 3));  // 15 + 15 edges
    EXPECT_EQ(expect_even(odd_twice).splits, 0);
    shapes::Shape shape = shapes::cylinder(15, 3);
    shape.triangles.push_back({1, 0, static_cast<std::int32_t>(shape.points.size())});  // an ear
    shape.points.push_back({1.2, 0.2, -0.3});
    SurfaceMesh odd = prepared(shape);
    ASSERT_EQ(count_odd_components(odd), 1);
    EXPECT_EQ(expect_even(odd).splits, 1);
}

TEST(Parity, ClosedSurfacesPairTheirOddPatches) {
    SurfaceMesh mesh = prepared(shapes::cube(3));
    // one split on an edge of the cube makes its two faces odd; on two opposite edges, four
    const HalfEdge along = [&] {
        for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
            if (mesh.is_constrained(M::edge(HalfEdge(i)))) return HalfEdge(i);
        }
        return HalfEdge();
    }();
    split_edge(mesh, M::edge(along), 0.5 * (mesh.position(mesh.from(along)) + mesh.position(mesh.to(along))));
    ASSERT_EQ(count_odd_components(mesh), 2);
    EXPECT_EQ(expect_even(mesh).splits, 1);
}

TEST(Parity, OddPatchesFarApartAreJoinedAcrossOthers) {
    // A band of patches on a closed surface: a torus cut by rings; each ring is split where it must be.
    const int n = 24;
    const int m = 12;
    std::vector<Source> rings;
    for (int r = 0; r < 4; ++r) {
        std::vector<std::int32_t> ring;
        for (int i = 0; i <= n; ++i) ring.push_back(3 * r * n + i % n);
        rings.push_back(source(ring));
    }
    shapes::Shape shape = shapes::torus(n, m);
    SurfaceMesh mesh = prepared(shape, rings);
    // splitting rings 0 and 2 makes all four patches odd; splitting ring 0 twice over would be the same as nothing
    for (const int r : {0, 2}) {
        const HalfEdge h = mesh.find_halfedge(Vertex(3 * r * n), Vertex(3 * r * n + 1));
        split_edge(mesh, M::edge(h), 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    }
    ASSERT_EQ(count_odd_components(mesh), 4);
    EXPECT_EQ(expect_even(mesh).splits, 2);

    SurfaceMesh far = prepared(shape, rings);
    for (const int r : {0, 1}) {  // patches 3|0 and 0|1: patch 0 stays even, 3 and 1 are odd and not neighbours
        const HalfEdge h = far.find_halfedge(Vertex(3 * r * n), Vertex(3 * r * n + 1));
        split_edge(far, M::edge(h), 0.5 * (far.position(far.from(h)) + far.position(far.to(h))));
    }
    ASSERT_EQ(count_odd_components(far), 2);
    EXPECT_EQ(expect_even(far).splits, 2);
}

TEST(Parity, QuadsDoNotBelong) {
    // A row of quads at the left end of a plane; the triangles beside it count the quads' edges.
    SurfaceMesh mesh = prepared(shapes::grid(4, 4));
    const auto merge = [&](int i, int j) {
        const std::int32_t a = 5 * j + i;
        HalfEdge h = mesh.find_halfedge(Vertex(a), Vertex(a + 6));
        if (!h.is_valid()) h = mesh.find_halfedge(Vertex(a + 1), Vertex(a + 5));
        dissolve_edge(mesh, M::edge(h));
    };
    merge(0, 0);
    EXPECT_EQ(count_odd_components(mesh), 0);
    // With a triangle taken away from the middle of a side, one edge becomes two.
    shapes::Shape shape = shapes::grid(4, 4);
    shape.triangles.erase(shape.triangles.begin() + 2);
    mesh = prepared(shape);
    ASSERT_EQ(count_odd_components(mesh), 1);
    for (int j = 1; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) merge(i, j);
    }
    const ParityResult result = expect_even(mesh);
    ASSERT_EQ(result.splits, 1);
    EXPECT_LT(mesh.position(result.new_nodes[0]).y(), 1.0);  // beside a triangle, not a quad
}

TEST(Parity, ATriangleAmongQuadsIsJoinedToTheRestByChords) {
    SurfaceMesh mesh = prepared(shapes::sphere(24, 16));
    for (const HalfEdge side : mesh.halfedges(Face(100))) {
        const HalfEdge first = mesh.next(M::twin(side));
        const HalfEdge h = is_flip_ok(mesh, M::edge(first)) ? first : mesh.next(first);
        ASSERT_TRUE(is_flip_ok(mesh, M::edge(h)));
        dissolve_edge(mesh, M::edge(h));
    }
    ASSERT_GT(count_odd_components(mesh), 0);
    const ParityResult result = make_parity_even(mesh);
    EXPECT_GT(result.splits, 0);
    EXPECT_TRUE(result.left.empty());
    EXPECT_EQ(count_odd_components(mesh), 0);
    EXPECT_TRUE(validate(mesh).empty());
}

TEST(Parity, AnEdgeWithTheSamePatchOnBothSidesIsNoHelp) {
    // A slit inside an odd plane: only the boundary can be split.
    shapes::Shape shape = shapes::grid(4, 4);
    shape.triangles.erase(shape.triangles.begin());
    SurfaceMesh mesh = prepared(shape, {source({11, 12, 13})});
    ASSERT_EQ(count_odd_components(mesh), 1);
    const ParityResult result = expect_even(mesh);
    ASSERT_EQ(result.splits, 1);
    EXPECT_TRUE(mesh.is_boundary(result.new_nodes[0]));
}

TEST(Parity, ManyRandomPatchesAreAllMadeEven) {
    // Every diagonal and some grid lines as feature edges, by a fixed rule: hundreds of small patches.
    for (const bool closed : {false, true}) {
        const shapes::Shape shape = closed ? shapes::torus(30, 18) : shapes::grid(20, 20);
        SurfaceMesh mesh = shape.mesh();
        Options options;
        for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
            const HalfEdge h = M::halfedge(Edge(i));
            if ((i * 2654435761u >> 7) % 3 == 0) options.feature_edges.push_back({mesh.from(h).index(), mesh.to(h).index()});
        }
        find_features(mesh, {}, options);
        find_patches(mesh);
        const ParityResult result = expect_even(mesh);
        EXPECT_TRUE(result.left.empty());
        EXPECT_GT(result.odd, 20);
        EXPECT_LE(result.splits, result.odd);
        SurfaceMesh again = shape.mesh();
        find_features(again, {}, options);
        find_patches(again);
        EXPECT_EQ(make_parity_even(again).new_nodes, result.new_nodes);
    }
}

}  // namespace
}  // namespace anisoquad
