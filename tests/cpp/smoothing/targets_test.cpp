// The four smoothers' targets and Blacker's combination: laplacian.h, length.h, angle.h, isoparametric.h, front_node.h.
#include <gtest/gtest.h>

#include "quad_grid.h"
#include "smoothing/angle.h"
#include "smoothing/front_node.h"
#include "smoothing/isoparametric.h"
#include "smoothing/laplacian.h"
#include "smoothing/length.h"

namespace anisoquad {
namespace {

using quad_grid::on_plane;
using Target = bool (*)(const SurfaceMesh&, Vertex, Point&);

struct Named {
    const char* name;
    Target target;
};
void PrintTo(const Named& n, std::ostream* out) { *out << n.name; }

class Smoother : public testing::TestWithParam<Named> {};
INSTANTIATE_TEST_SUITE_P(All, Smoother,
                         testing::Values(Named{"laplacian", laplacian_target}, Named{"length", length_target},
                                         Named{"angle", angle_target}, Named{"isoparametric", isoparametric_target}),
                         [](const auto& smoother) { return std::string(smoother.param.name); });

TEST_P(Smoother, LeavesARegularGridAlone) {
    const quad_grid::Grid g = quad_grid::make(4, 4, on_plane);
    const SurfaceMesh mesh = g.mesh();
    Point target;
    ASSERT_TRUE(GetParam().target(mesh, g.vertex(2, 2), target));
    EXPECT_LT((target - mesh.position(g.vertex(2, 2))).norm(), 1e-12);
}

TEST_P(Smoother, BringsADisplacedNodeNearer) {
    const quad_grid::Grid g = quad_grid::make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    const Vertex v = g.vertex(2, 2);
    const Point home = mesh.position(v);
    mesh.position(v) += Eigen::Vector3d(0.08, 0.05, 0.0);
    for (int i = 0; i < 20; ++i) {
        Point target;
        ASSERT_TRUE(GetParam().target(mesh, v, target));
        mesh.position(v) = target;
    }
    EXPECT_LT((mesh.position(v) - home).norm(), 0.02);
}

TEST_P(Smoother, ScaleAndPlaceDontMatter) {
    const quad_grid::Grid g = quad_grid::make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    quad_grid::distort(mesh, g, on_plane, 0.3);
    const Vertex v = g.vertex(2, 1);
    Point expected;
    ASSERT_TRUE(GetParam().target(mesh, v, expected));
    for (const auto& [scale, offset] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e3)}) {
        SurfaceMesh other = mesh;
        const Eigen::Vector3d shift = Eigen::Vector3d::Constant(offset);
        for (std::int32_t i = 0; i < other.vertex_slots(); ++i)
            other.position(Vertex(i)) = scale * mesh.position(Vertex(i)) + shift;
        Point target;
        ASSERT_TRUE(GetParam().target(other, v, target));
        EXPECT_LT(((target - shift) / scale - expected).norm(), 1e-9);
    }
}

TEST(Isoparametric, CompletesTheParallelogram) {
    const quad_grid::Grid g = quad_grid::make(1, 1, on_plane);
    SurfaceMesh mesh = g.mesh();
    mesh.position(g.vertex(1, 1)) = {0.6, 0.7, 0.0};
    Point target;
    ASSERT_TRUE(isoparametric_target(mesh, g.vertex(1, 1), target));
    EXPECT_LT((target - Point(1, 1, 0)).norm(), 1e-12);
}

TEST(Isoparametric, NeedsAQuad) {
    const quad_grid::Grid g = quad_grid::make(1, 1, on_plane);
    const SurfaceMesh mesh = from_arrays(g.points, g.triangles);
    Point target;
    EXPECT_FALSE(isoparametric_target(mesh, Vertex(0), target));
    EXPECT_FALSE(front_node_target(mesh, Vertex(0), target));
}

TEST(FrontNode, GivesEvenRowsOverAStraightFront) {
    // One row of quads over y = 0: the node on top of the middle column was placed askew and too low.
    const quad_grid::Grid g = quad_grid::make(4, 1, [](double x, double y) { return Point(4.0 * x, y, 0.0); });
    SurfaceMesh mesh = g.mesh();
    const Vertex v = g.vertex(2, 1);
    mesh.position(v) = {2.3, 0.6, 0.0};
    for (int i = 0; i < 20; ++i) {
        Point target;
        ASSERT_TRUE(front_node_target(mesh, v, target));
        mesh.position(v) = target;
    }
    EXPECT_LT((mesh.position(v) - Point(2, 1, 0)).norm(), 0.05);
}

TEST(FrontNode, StaysOnItsSideInAConcaveCorner) {
    // The lower front turns by 90° to the left below the node: the bisector goes into the corner's inside.
    const quad_grid::Grid g = quad_grid::make(2, 1, [](double x, double y) {
        const double s = 2.0 * x - 1.0;
        const Eigen::Vector3d along = s < 0.0 ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(1, 0, 0);
        return Point(std::abs(s) * along * (1.0 - 0.3 * y) + y * Eigen::Vector3d(0.6, 0.6, 0));
    });
    const SurfaceMesh mesh = g.mesh();
    Point target;
    ASSERT_TRUE(front_node_target(mesh, g.vertex(1, 1), target));
    EXPECT_GT(target.x(), 0.1);
    EXPECT_GT(target.y(), 0.1);
    EXPECT_NEAR(target.x(), target.y(), 1e-9);
}

}  // namespace
}  // namespace anisoquad
