#include "mesh/quad_chord.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "mesh/validate.h"
#include "shapes.h"
#include "stages.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// Four by three cells of which the middle columns are quads; the others keep their triangles.
SurfaceMesh mixed() {
    SurfaceMesh mesh = shapes::grid(4, 3).mesh();
    for (std::int32_t f = 0; f < 24; f += 2) {
        if (f / 2 % 4 == 0 || f / 2 % 4 == 3) continue;
        for (const HalfEdge h : mesh.halfedges(Face(f))) {
            if (mesh.face(M::twin(h)) != Face(f + 1)) continue;
            dissolve_edge(mesh, M::edge(h));
            break;
        }
    }
    return mesh;
}

HalfEdge in_triangle(const SurfaceMesh& mesh, std::int32_t a, std::int32_t b) {
    const HalfEdge h = mesh.find_halfedge(Vertex(a), Vertex(b));
    return !mesh.is_boundary(h) && mesh.is_triangle(mesh.face(h)) ? h : M::twin(h);
}

TEST(QuadChord, GoesThroughQuadsToTheTrianglesBeyond) {
    const SurfaceMesh mesh = mixed();
    int quads = 0;
    const HalfEdge end = chord_end(mesh, in_triangle(mesh, 6, 11), quads);  // from x = 1 to x = 3
    EXPECT_EQ(quads, 2);
    EXPECT_EQ(M::edge(end), M::edge(mesh.find_halfedge(Vertex(8), Vertex(13))));
    EXPECT_TRUE(mesh.is_triangle(mesh.face(end)));
}

TEST(QuadChord, EndsAtTheBoundary) {
    const SurfaceMesh mesh = mixed();
    int quads = 0;
    const HalfEdge start = mesh.find_halfedge(Vertex(2), Vertex(1));
    ASSERT_TRUE(mesh.is_boundary(start));
    const HalfEdge end = chord_end(mesh, start, quads);
    EXPECT_EQ(quads, 3);
    EXPECT_TRUE(mesh.is_boundary(end));
}

TEST(QuadChord, SplittingHalvesQuadsAndTheTrianglesAtItsEnds) {
    SurfaceMesh mesh = mixed();
    const Topology before = topology(mesh);
    const int triangles = stages::triangle_count(mesh);
    std::vector<Vertex> nodes;
    split_chord(mesh, in_triangle(mesh, 6, 11), nodes);
    ASSERT_EQ(nodes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(mesh.position(nodes[i]).isApprox(Point(1.0 + static_cast<double>(i), 1.5, 0.0)));
    EXPECT_EQ(stages::triangle_count(mesh), triangles + 2);
    EXPECT_EQ(stages::quad_count(mesh), 6 + 2);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(topology(mesh) == before);
}

TEST(QuadChord, AnEdgeBetweenTrianglesIsAChordWithoutQuads) {
    SurfaceMesh mesh = shapes::grid(2, 1).mesh();
    std::vector<Vertex> nodes;
    int quads = 1;
    const HalfEdge h = mesh.find_halfedge(Vertex(1), Vertex(4));
    EXPECT_EQ(chord_end(mesh, h, quads), M::twin(h));
    EXPECT_EQ(quads, 0);
    split_chord(mesh, h, nodes);
    EXPECT_EQ(nodes.size(), 1u);
    EXPECT_EQ(stages::triangle_count(mesh), 6);
    EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace anisoquad
