#include "anisotropy/merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "anisotropy/grid_rows.h"

namespace anisoquad {
namespace {

using namespace stages;

const std::vector<char> kKept{1, 0, 1, 0, 0, 1, 0, 1, 1};  // segments of 2, 3, 2, 1

TEST(Merge, TheQuadsOfASegmentBecomeOneInEveryRow) {
    GridRows p(8, 6, 0, 3);
    const std::vector<Vertex> source_nodes = p.stack.layers[0];
    const std::vector<Vertex> top = p.stack.layers[3];
    merge_rows(p.mesh, p.stack, kKept);
    EXPECT_EQ(merge_source_nodes(p.mesh, source_nodes, kKept), 0);
    ASSERT_EQ(p.stack.layers.size(), 4u);
    EXPECT_EQ(p.stack.layers[3], top);  // the uppermost layer keeps its nodes
    const std::vector<int> columns{0, 2, 5, 7, 8};
    for (int j = 0; j < 3; ++j) {
        const auto& layer = p.stack.layers[static_cast<std::size_t>(j)];
        ASSERT_EQ(layer.size(), columns.size());
        for (std::size_t i = 0; i < columns.size(); ++i) EXPECT_EQ(layer[i], p.node(columns[i], j));
        for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
            const Face f = p.face(layer[i], layer[i + 1]);
            ASSERT_TRUE(f.is_valid());
            EXPECT_EQ(p.mesh.info(f).row, j + 1);
            EXPECT_EQ(p.mesh.info(f).pass, 1);
            EXPECT_EQ(p.mesh.info(f).source, 0);
            const int width = columns[i + 1] - columns[i];
            EXPECT_EQ(p.mesh.valence(f), j < 2 ? 4 : width + 3);
            EXPECT_NEAR(doubled_area(p.mesh, f).z(), 2.0 * width, 1e-12);
        }
    }
    for (int i = 0; i <= 8; ++i) EXPECT_EQ(p.mesh.is_deleted(p.node(i, 1)), kKept[static_cast<std::size_t>(i)] == 0);
    EXPECT_TRUE(topology(p.mesh) == p.before);
}

TEST(Merge, EdgesOfTheSourceStaySource) {
    GridRows p(8, 6, 0, 2);
    const std::vector<Vertex> source_nodes = p.stack.layers[0];
    merge_rows(p.mesh, p.stack, kKept);
    merge_source_nodes(p.mesh, source_nodes, kKept);
    for (std::size_t i = 0; i + 1 < p.stack.layers[0].size(); ++i) {
        const HalfEdge h = p.mesh.find_halfedge(p.stack.layers[0][i], p.stack.layers[0][i + 1]);
        EXPECT_TRUE(p.mesh.info(SurfaceMesh::edge(h)).source);
        EXPECT_GE(p.mesh.info(SurfaceMesh::edge(h)).line, 0);
    }
}

TEST(Merge, NothingIsMergedWhereAllAreKept) {
    GridRows p(8, 6, 0, 3);
    const std::vector<char> all(9, 1);
    const auto before = p.stack.layers;
    merge_rows(p.mesh, p.stack, all);
    EXPECT_EQ(merge_source_nodes(p.mesh, before[0], all), 0);
    EXPECT_EQ(p.stack.layers, before);
    EXPECT_EQ(quad_count(p.mesh), 24);
    expect_sound(p);
}

TEST(Merge, TrianglesOnASideWithoutRowsAreCollapsedAlongTheSource) {
    for (const std::vector<char>& kept : {kKept, std::vector<char>{1, 0, 0, 0, 1, 0, 0, 0, 1}}) {
        GridRows p(8, 6, 3, 2);
        const std::vector<Vertex> source_nodes = p.stack.layers[0];
        merge_rows(p.mesh, p.stack, kept);
        EXPECT_EQ(merge_source_nodes(p.mesh, source_nodes, kept), 0);
        EXPECT_TRUE(topology(p.mesh) == p.before);
        EXPECT_EQ(inverted_triangles(p), 0);
        for (std::size_t i = 0; i + 1 < p.stack.layers[0].size(); ++i) {
            const HalfEdge h = p.mesh.find_halfedge(p.stack.layers[0][i], p.stack.layers[0][i + 1]);
            ASSERT_TRUE(h.is_valid());
            EXPECT_TRUE(p.mesh.is_quad(p.mesh.face(h)));
            EXPECT_TRUE(p.mesh.is_triangle(p.mesh.face(SurfaceMesh::twin(h))));
        }
    }
}

TEST(Merge, SourceNodesThatTheTrianglesHoldTightAreFreed) {
    GridRows p(8, 6, 3, 2);
    const std::vector<Vertex> source_nodes = p.stack.layers[0];
    merge_rows(p.mesh, p.stack, kKept);
    // A node inside of the triangle beside each edge: the edge's ends then have a common neighbour beyond it.
    for (std::size_t i = 0; i + 1 < source_nodes.size(); ++i) {
        const HalfEdge h = p.mesh.find_halfedge(source_nodes[i + 1], source_nodes[i]);
        ASSERT_TRUE(p.mesh.is_triangle(p.mesh.face(h)));
        const Point middle =
            (p.mesh.position(p.mesh.from(h)) + p.mesh.position(p.mesh.to(h)) + p.mesh.position(p.mesh.to(p.mesh.next(h)))) / 3.0;
        split_face(p.mesh, p.mesh.face(h), middle);
    }
    EXPECT_EQ(merge_source_nodes(p.mesh, source_nodes, kKept), 0);
    EXPECT_TRUE(topology(p.mesh) == p.before);
    for (std::size_t i = 0; i + 1 < p.stack.layers[0].size(); ++i) {
        const HalfEdge h = p.mesh.find_halfedge(p.stack.layers[0][i], p.stack.layers[0][i + 1]);
        ASSERT_TRUE(h.is_valid());
        EXPECT_TRUE(p.mesh.is_quad(p.mesh.face(h)));
    }
}

TEST(Merge, ANodeAtTheTipOfATriangleGoesWithTheTriangle) {
    SurfaceMesh mesh = shapes::grid(1, 1).mesh();  // node 1 is in one triangle only
    EXPECT_EQ(merge_source_nodes(mesh, {Vertex(0), Vertex(1), Vertex(3)}, {1, 0, 1}), 0);
    EXPECT_EQ(mesh.face_count(), 1);
    EXPECT_TRUE(validate(mesh).empty());
}

TEST(Merge, AStackWithoutRowsOnlyLosesSourceNodes) {
    GridRows p(8, 6, 3, 0);
    const std::vector<Vertex> source_nodes = p.stack.layers[0];
    merge_rows(p.mesh, p.stack, kKept);
    EXPECT_EQ(merge_source_nodes(p.mesh, source_nodes, kKept), 0);
    EXPECT_EQ(p.stack.layers[0].size(), 5u);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

}  // namespace
}  // namespace anisoquad
