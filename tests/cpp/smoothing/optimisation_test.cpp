#include "smoothing/optimisation.h"

#include <gtest/gtest.h>

#include "quad_grid.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

TEST(Optimisation, NeverMakesTheWorstWorse) {
    const Grid g = make(8, 8, on_sphere);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_sphere, 0.4);
    const ReferenceSurface reference = g.reference();
    int moved = 0;
    for (int j = 1; j < 8; ++j) {
        for (int i = 1; i < 8; ++i) {
            const Vertex v = g.vertex(i, j);
            const Eigen::Vector3d up = node_normal(mesh, v);
            const double before = worst_quality(mesh, v, up);
            moved += optimise_node(mesh, v, &reference) ? 1 : 0;
            if (before > 0.0) {
                EXPECT_GE(worst_quality(mesh, v, up), before - 0.011);  // the mean breaks ties with a weight of 0.01
            }
        }
    }
    EXPECT_GT(moved, 20);
}

TEST(Optimisation, Untangles) {
    const Grid g = make(12, 12, on_plane);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_plane, 0.65);
    ASSERT_LT(quality(mesh).min, 0.0);
    for (int sweep = 0; sweep < 10; ++sweep) {
        for (int j = 1; j < 12; ++j) {
            for (int i = 1; i < 12; ++i) optimise_node(mesh, g.vertex(i, j));
        }
    }
    EXPECT_GT(quality(mesh).min, 0.3);
}

TEST(Optimisation, KeepsWhatMustStay) {
    const Grid g = make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_plane, 0.4);
    mesh.info(g.vertex(2, 2)).in_row = true;
    for (const Vertex v : {g.vertex(2, 2), g.vertex(0, 2), g.vertex(0, 0)}) EXPECT_FALSE(optimise_node(mesh, v));
}

}  // namespace
}  // namespace anisoquad
