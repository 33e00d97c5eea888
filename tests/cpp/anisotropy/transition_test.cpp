#include "anisotropy/transition.h"

#include <gtest/gtest.h>

#include "anisotropy/grid_rows.h"
#include "anisotropy/merge.h"

namespace anisoquad {
namespace {

using namespace stages;

const std::vector<char> kKept{1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1};  // segments of 2, 3, 1, 4

GridRows merged(int rows) {
    GridRows p(10, 6, 0, rows);
    const std::vector<Vertex> source_nodes = p.stack.layers[0];
    merge_rows(p.mesh, p.stack, kKept);
    merge_source_nodes(p.mesh, source_nodes, kKept);
    return p;
}

TEST(Transition, TheUppermostRowBecomesFansOfTriangles) {
    for (const int rows : {1, 2, 3}) {
        GridRows p = merged(rows);
        const std::vector<Vertex> above = p.stack.layers.back();
        const int triangles = triangle_count(p.mesh);
        give_back_top_row(p.mesh, p.stack);
        expect_sound(p);  // no face of more than four edges, so no hanging node; no hole
        EXPECT_EQ(p.stack.rows(), static_cast<std::size_t>(rows - 1));
        EXPECT_EQ(p.stack.pass_of_row.size(), p.stack.rows());
        EXPECT_EQ(quad_count(p.mesh), 4 * (rows - 1));
        EXPECT_EQ(triangle_count(p.mesh), triangles + 10 + 4);  // one on each edge above, one on each merged edge
        EXPECT_EQ(inverted_triangles(p), 0);
        EXPECT_NEAR(signed_area(p), 60.0, 1e-9);
        for (const Vertex v : above) EXPECT_FALSE(p.mesh.info(v).in_row);
        for (const Vertex v : p.stack.top()) EXPECT_TRUE(p.mesh.info(v).in_row);
    }
}

TEST(Transition, EveryFanHasItsMergedEdgeAsBase) {
    GridRows p = merged(2);
    const std::vector<Vertex> above = p.stack.layers.back();
    give_back_top_row(p.mesh, p.stack);
    const auto& below = p.stack.top();
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
        const Face f = p.face(below[i], below[i + 1]);
        EXPECT_TRUE(p.mesh.is_triangle(f));
    }
    // Every edge above has a triangle below it whose apex is an end of the merged edge under it.
    for (std::size_t i = 0; i + 1 < above.size(); ++i) {
        const HalfEdge h = p.mesh.find_halfedge(above[i + 1], above[i]);
        ASSERT_TRUE(p.mesh.is_triangle(p.mesh.face(h)));
        EXPECT_NEAR(p.mesh.position(p.mesh.to(p.mesh.next(h))).y(), 1.0, 1e-12);
    }
}

TEST(Transition, TheTrianglesBelongToNoRow) {
    GridRows p = merged(3);
    give_back_top_row(p.mesh, p.stack);
    for (const Face f : faces(p.mesh)) {
        const FaceInfo& info = p.mesh.info(f);
        EXPECT_EQ(info.patch, 0);
        EXPECT_EQ(info.row > 0, p.mesh.is_quad(f));
        EXPECT_EQ(info.source >= 0, p.mesh.is_quad(f));
        EXPECT_EQ(info.pass > 0, p.mesh.is_quad(f));
    }
}

}  // namespace
}  // namespace anisoquad
