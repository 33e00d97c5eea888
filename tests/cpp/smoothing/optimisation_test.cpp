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

/// Two lines at eight degrees; the middle node of two times two quads between them is opposite their corner.
SurfaceMesh between_two_lines(const Grid& g) {
    SurfaceMesh mesh = g.mesh();
    mesh.position(g.vertex(1, 0)) = {1.0, -0.07, 0.0};
    mesh.position(g.vertex(0, 1)) = {1.0, 0.07, 0.0};
    mesh.position(g.vertex(1, 1)) = {1.05, -0.055, 0.0};
    mesh.position(g.vertex(2, 0)) = {1.3, -0.09, 0.0};
    mesh.position(g.vertex(0, 2)) = {1.3, 0.09, 0.0};
    mesh.position(g.vertex(2, 1)) = {1.3, -0.04, 0.0};
    mesh.position(g.vertex(1, 2)) = {1.3, 0.04, 0.0};
    mesh.position(g.vertex(2, 2)) = {1.4, 0.0, 0.0};
    return mesh;
}

TEST(Optimisation, ASharpCornerOppositeTheNodeDoesNotHideItsNeighbours) {
    const Grid g = make(2, 2, on_plane);
    const auto beside = [&](const SurfaceMesh& mesh) {
        const HalfEdge h = mesh.find_halfedge(g.vertex(1, 0), g.vertex(2, 0));
        return scaled_jacobian(mesh, mesh.face(h));
    };
    const auto corner = [&](const SurfaceMesh& mesh) {
        return scaled_jacobian(mesh, mesh.face(mesh.find_halfedge(g.vertex(0, 0), g.vertex(1, 0))));
    };
    const auto optimised = [&](Aim aim) {
        SurfaceMesh mesh = between_two_lines(g);
        for (int i = 0; i < 3; ++i) optimise_node(mesh, g.vertex(1, 1), nullptr, nullptr, aim);
        return mesh;
    };
    const double limit = std::sin(2.0 * std::atan(0.07));
    ASSERT_NEAR(corner(between_two_lines(g)), limit, 1e-9);
    ASSERT_LT(beside(between_two_lines(g)), 0.35);
    const SurfaceMesh mesh = optimised(Aim::worst_changing_corner);
    EXPECT_NEAR(corner(mesh), limit, 1e-9);
    EXPECT_GT(beside(mesh), 0.45);
    EXPECT_LT(beside(optimised(Aim::worst_element)), 0.4);
}

TEST(Optimisation, KeepsWhatMustStay) {
    const Grid g = make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_plane, 0.4);
    mesh.info(g.vertex(2, 2)).in_row = true;
    for (const Vertex v : {g.vertex(2, 2), g.vertex(0, 2), g.vertex(0, 0)}) EXPECT_FALSE(optimise_node(mesh, v));
}

TEST(Optimisation, ANodeInANarrowStripComesToFaceTheOthers) {
    // Two rows of quads between two lines that are a thousandth of a quad's length apart; the middle node lags behind by half a
    // length. However the strip lies, all steps but those along it would lead out of it.
    for (const double turn : {0.0, 0.3, 1.2, 2.7}) {
        const Grid g = make(2, 2, on_plane);
        SurfaceMesh mesh = g.mesh();
        const Eigen::AngleAxisd rotation(turn, Eigen::Vector3d::UnitZ());
        for (int j = 0; j <= 2; ++j) {
            for (int i = 0; i <= 2; ++i) mesh.position(g.vertex(i, j)) = rotation * Point(i, 0.001 * j, 0.0);
        }
        const Vertex middle = g.vertex(1, 1);
        mesh.position(middle) = rotation * Point(0.5, 0.001, 0.0);
        ASSERT_LT(worst_quality(mesh, middle, Eigen::Vector3d::UnitZ()), 0.01);
        for (int i = 0; i < 20; ++i) optimise_node(mesh, middle, nullptr, nullptr, Aim::worst_changing_corner);
        EXPECT_GT(worst_quality(mesh, middle, Eigen::Vector3d::UnitZ()), 0.5) << turn;
    }
}

}  // namespace
}  // namespace anisoquad
