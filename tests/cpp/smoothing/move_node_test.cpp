#include "smoothing/move_node.h"

#include <gtest/gtest.h>

#include "quad_grid.h"
#include "smoothing/laplacian.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

TEST(MoveNode, NeverInvertsAnElement) {
    const Grid g = make(6, 6, on_plane);
    const ReferenceSurface plane = g.reference();
    // By the polynomial round the node, and by the surface, whose tangent plane will do here.
    for (const ReferenceSurface* reference : {static_cast<const ReferenceSurface*>(nullptr), &plane}) {
        SurfaceMesh mesh = g.mesh();
        distort(mesh, g, on_plane, 0.3);
        ASSERT_GT(quality(mesh).min, 0.0);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> anywhere(-1.0, 2.0);
        std::uniform_int_distribution<int> node(1, 5);
        int moves = 0;
        for (int k = 0; k < 500; ++k) {
            const Vertex v = g.vertex(node(random), node(random));
            const double before = worst_quality(mesh, v, {0, 0, 1});
            moves += move_node(mesh, v, {anywhere(random), anywhere(random), 0.0}, reference);
            const double after = worst_quality(mesh, v, {0, 0, 1});
            EXPECT_GE(after, std::min(before, 0.5));
            EXPECT_GT(after, 0.0);
        }
        EXPECT_GT(moves, 50);
        EXPECT_GT(quality(mesh).min, 0.0);
    }
}

TEST(MoveNode, KeepsWhatMustStay) {
    const Grid g = make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    mesh.info(g.vertex(2, 2)).in_row = true;
    mesh.info(g.vertex(1, 2)).kind = NodeKind::line;
    mesh.info(g.vertex(2, 1)).kind = NodeKind::corner;
    for (const Vertex v : {g.vertex(2, 2), g.vertex(1, 2), g.vertex(2, 1), g.vertex(0, 2), g.vertex(0, 0)}) {
        const Point before = mesh.position(v);
        EXPECT_FALSE(is_movable(mesh, v));
        EXPECT_FALSE(move_node(mesh, v, before + Eigen::Vector3d(0.01, 0.01, 0.0)));
        EXPECT_EQ(mesh.position(v), before);
    }
}

TEST(MoveNode, StaysOnTheSurface) {
    const Grid g = make(16, 16, on_sphere);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_sphere, 0.25);
    SurfaceMesh projected = mesh;
    const ReferenceSurface reference = g.reference();
    for (int sweep = 0; sweep < 5; ++sweep) {
        for (int j = 1; j < 16; ++j) {
            for (int i = 1; i < 16; ++i) {
                Point target;
                ASSERT_TRUE(laplacian_target(mesh, g.vertex(i, j), target));
                move_node(mesh, g.vertex(i, j), target);
                ASSERT_TRUE(laplacian_target(projected, g.vertex(i, j), target));
                move_node(projected, g.vertex(i, j), target, &reference);
            }
        }
    }
    double fitted_drift = 0.0;
    double projected_drift = 0.0;
    for (int j = 1; j < 16; ++j) {
        for (int i = 1; i < 16; ++i) {
            fitted_drift = std::max(fitted_drift, std::abs(mesh.position(g.vertex(i, j)).norm() - 1.0));
            projected_drift = std::max(projected_drift, std::abs(projected.position(g.vertex(i, j)).norm() - 1.0));
        }
    }
    // The sagitta of a cell's diagonal is 0.0015: the fit stays well within it, the reference bounds it for good.
    EXPECT_LT(fitted_drift, 1.5e-3);
    EXPECT_LT(projected_drift, 5e-4);
    EXPECT_GT(quality(projected).min, quality(g.mesh()).min - 0.2);
}

TEST(MoveNode, MovedNodesAreNoInputNodesAnyMore) {
    const Grid g = make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    const Vertex v = g.vertex(2, 2);
    EXPECT_EQ(mesh.info(v).input, v.index());
    EXPECT_FALSE(move_node(mesh, v, mesh.position(v)));
    EXPECT_EQ(mesh.info(v).input, v.index());
    EXPECT_TRUE(move_node(mesh, v, mesh.position(v) + Eigen::Vector3d(0.02, 0.0, 0.0)));
    EXPECT_EQ(mesh.info(v).input, -1);
}

TEST(MoveNode, AFoldedStarMayOnlyUnfold) {
    const Grid g = make(4, 4, on_plane);
    const ReferenceSurface plane = g.reference();
    for (const ReferenceSurface* reference : {static_cast<const ReferenceSurface*>(nullptr), &plane}) {
        SurfaceMesh mesh = g.mesh();
        const Vertex v = g.vertex(2, 2);
        const Point home = mesh.position(v);
        mesh.position(v) = {0.9, 0.5, 0.0};  // beyond the neighbour on the right
        ASSERT_LT(worst_quality(mesh, v, {0, 0, 1}), 0.0);
        EXPECT_FALSE(move_node(mesh, v, {1.2, 0.5, 0.0}, reference));
        EXPECT_TRUE(move_node(mesh, v, home, reference));
        for (int i = 0; i < 5; ++i) move_node(mesh, v, home, reference);
        EXPECT_GT(worst_quality(mesh, v, {0, 0, 1}), 0.5);
    }
}

}  // namespace
}  // namespace anisoquad
