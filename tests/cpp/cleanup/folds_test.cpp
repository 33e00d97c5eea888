#include "cleanup/folds.h"

#include <gtest/gtest.h>

#include "cleanup/quad_shapes.h"

namespace anisoquad {
namespace {

/// Two sheets that meet at the line of nodes x = 2: the right one is folded back under the left one.
SurfaceMesh folded() {
    SurfaceMesh mesh = shapes::quad_grid(4, 2);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        Point& p = mesh.position(Vertex(i));
        if (p.x() > 2.0) p = Point(4.0 - p.x(), p.y(), -1e-3 * (p.x() - 2.0));
    }
    return mesh;
}

std::vector<Face> all_faces(const SurfaceMesh& mesh) {
    std::vector<Face> faces;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (!mesh.is_deleted(Face(i))) faces.emplace_back(i);
    }
    return faces;
}

TEST(Folds, APlaneHasNone) {
    const SurfaceMesh mesh = shapes::quad_grid(4, 2);
    EXPECT_EQ(count_folds(mesh, all_faces(mesh)), 0);
}

TEST(Folds, EveryEdgeAtWhichTheMeshTurnsOverCountsOnce) {
    const SurfaceMesh mesh = folded();
    EXPECT_EQ(count_folds(mesh, all_faces(mesh)), 2);
}

TEST(Folds, LinesMayBeFolded) {
    SurfaceMesh mesh = folded();
    mesh.info(SurfaceMesh::edge(mesh.find_halfedge(Vertex(2), Vertex(7)))).line = 1;
    EXPECT_EQ(count_folds(mesh, all_faces(mesh)), 1);
}

}  // namespace
}  // namespace anisoquad
