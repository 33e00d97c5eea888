#include "prepare/collapse_check.h"

#include <gtest/gtest.h>

#include "mesh/arrays.h"

namespace anisoquad {
namespace {

const std::vector<Point> kPoints{{0, 0, 0}, {0.5, -0.1, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}};
const std::vector<std::array<std::int32_t, 3>> kTriangles{{0, 2, 3}, {0, 1, 2}, {0, 4, 1}, {1, 4, 2}};

/// Whether the line 0, 1, 2 may lose its middle.
bool middle_may_go(bool line_across) {
    SurfaceMesh mesh = from_arrays(kPoints, kTriangles);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) mesh.info(Vertex(i)).size = 1.0;
    const auto mark = [&](std::int32_t a, std::int32_t b, std::int32_t line) {
        mesh.info(SurfaceMesh::edge(mesh.find_halfedge(Vertex(a), Vertex(b)))).line = line;
    };
    mark(0, 1, 0);
    mark(1, 2, 0);
    if (line_across) mark(0, 2, 1);
    return may_collapse(mesh, mesh.find_halfedge(Vertex(1), Vertex(0)), ReferenceSurface(kPoints, kTriangles), 0.1);
}

TEST(MayCollapse, ANodeOfALineMayGo) { EXPECT_TRUE(middle_may_go(false)); }

TEST(MayCollapse, NotTheTriangleThatKeepsTwoLinesApart) { EXPECT_FALSE(middle_may_go(true)); }

}  // namespace
}  // namespace anisoquad
