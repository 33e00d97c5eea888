#include "smoothing/final_smoothing.h"

#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "quad_grid.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

class FinalSmoothing : public testing::TestWithParam<Map> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, FinalSmoothing, testing::Values(&on_plane, &on_sphere, &on_cylinder), name_of);

TEST_P(FinalSmoothing, ImprovesDistortedGrids) {
    const Grid g = make(16, 16, GetParam());
    const ReferenceSurface reference = g.reference();
    for (const double amount : {0.2, 0.4, 0.6}) {  // the last one has inverted quads
        SurfaceMesh mesh = g.mesh();
        distort(mesh, g, GetParam(), amount);
        const Quality before = quality(mesh);
        const FinalSmoothingResult result = smooth_mesh(mesh, reference);
        const Quality after = quality(mesh);
        EXPECT_DOUBLE_EQ(result.min_before, before.min);
        EXPECT_DOUBLE_EQ(result.min_after, after.min);
        EXPECT_NEAR(result.mean_after, after.mean, 1e-12);
        EXPECT_EQ(result.inverted, 0);
        EXPECT_GT(after.min, std::max(before.min, 0.6)) << amount;
        EXPECT_GT(after.mean, std::max(before.mean, 0.9)) << amount;
        EXPECT_LE(result.sweeps, Options().smoothing_passes);
        for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
            EXPECT_LE(reference.closest(mesh.position(Vertex(i))).distance, 5.01e-4 * reference.diagonal());
        }
    }
}

TEST_P(FinalSmoothing, KeepsCornersAndLines) {
    const Grid g = make(12, 12, GetParam());
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, GetParam(), 0.4);
    // A bent feature line across the middle, and a corner in it.
    for (int i = 0; i < 12; ++i) mesh.info(SurfaceMesh::edge(mesh.find_halfedge(g.vertex(i, 6), g.vertex(i + 1, 6)))).line = 1;
    for (int i = 1; i < 12; ++i) mesh.info(g.vertex(i, 6)).kind = i == 6 ? NodeKind::corner : NodeKind::line;
    const SurfaceMesh before = mesh;
    smooth_mesh(mesh, g.reference());
    for (int i = 1; i < 12; ++i) EXPECT_EQ(mesh.position(g.vertex(i, 6)), before.position(g.vertex(i, 6))) << "bent line";
    for (const int i : {0, 12}) {
        for (const int j : {0, 12}) EXPECT_EQ(mesh.position(g.vertex(i, j)), before.position(g.vertex(i, j)));
    }
    // Boundary nodes are still on the boundary of the reference: within rounding of a segment of the input's.
    for (int i = 1; i < 12; ++i) {
        const Point& p = mesh.position(g.vertex(i, 0));
        double nearest = 1.0;
        for (int k = 0; k < 12; ++k) {
            const Point& a = g.points[std::size_t(k)];
            const Eigen::Vector3d e = g.points[std::size_t(k) + 1] - a;
            nearest = std::min(nearest, (p - a - std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm());
        }
        EXPECT_LT(nearest, 1e-6);
    }
    EXPECT_TRUE(validate(mesh).empty());
}

TEST_P(FinalSmoothing, GivesTheSameBytesTwice) {
    const Grid g = make(12, 12, GetParam());
    SurfaceMesh a = g.mesh();
    distort(a, g, GetParam(), 0.4);
    SurfaceMesh b = a;
    smooth_mesh(a, g.reference());
    smooth_mesh(b, g.reference());
    for (std::int32_t i = 0; i < a.vertex_slots(); ++i) EXPECT_EQ(a.position(Vertex(i)), b.position(Vertex(i)));
}

TEST(FinalSmoothing, SizeAndPlaceDontMatter) {
    const Grid g = make(10, 10, on_sphere);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_sphere, 0.4);
    for (const auto& [scale, offset] : {std::pair(1e-6, 0.0), std::pair(1024.0, 0.0), std::pair(1.0, 1e3)}) {
        Grid moved = g;
        const Eigen::Vector3d shift = Eigen::Vector3d::Constant(offset);
        for (Point& p : moved.points) p = scale * p + shift;
        SurfaceMesh a = mesh;
        SurfaceMesh b = mesh;
        for (std::int32_t i = 0; i < b.vertex_slots(); ++i) b.position(Vertex(i)) = scale * mesh.position(Vertex(i)) + shift;
        const FinalSmoothingResult x = smooth_mesh(a, g.reference());
        const FinalSmoothingResult y = smooth_mesh(b, moved.reference());
        EXPECT_NEAR(x.min_after, y.min_after, 1e-2);
        EXPECT_NEAR(x.mean_after, y.mean_after, 1e-3);
    }
}

TEST(FinalSmoothing, FoldedSharpEdgesAreNotTurnedOver) {
    // A wedge that turns by 39° per column, no feature: the reference's facets are far from any tangent plane.
    const auto wedge = [](double x, double y) {
        const double t = 9.0 * (x - 0.5);  // arc of radius 1 in nine steps of a radian/1.5
        return Point(std::sin(0.68 * t), 3.0 * y, std::cos(0.68 * t));
    };
    const Grid g = make(9, 6, wedge);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, wedge, 0.3);
    const ReferenceSurface reference = g.reference();
    smooth_mesh(mesh, reference);
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_deleted(Face(f))) continue;
        Point middle = Point::Zero();
        std::vector<Point> p;
        for (HalfEdge h : mesh.halfedges(Face(f))) p.push_back(mesh.position(mesh.from(h)));
        for (const Point& q : p) middle += 0.25 * q;
        const SurfacePoint foot = reference.closest(middle);
        EXPECT_GT((p[2] - p[0]).cross(p[3] - p[1]).normalized().dot(foot.normal), 0.5);
    }
    EXPECT_GT(quality(mesh).min, 0.3);
}

TEST(FinalSmoothing, StopsWhenCancelledAndDoesNothingWithoutPasses) {
    const Grid g = make(8, 8, on_plane);
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, on_plane, 0.3);
    const SurfaceMesh before = mesh;
    Options options;
    options.smoothing_passes = 0;
    EXPECT_EQ(smooth_mesh(mesh, g.reference(), options).moves, 0);
    EXPECT_EQ(mesh.position(g.vertex(3, 3)), before.position(g.vertex(3, 3)));
    Context cancelled([](std::string_view, double) { return false; });
    EXPECT_THROW(smooth_mesh(mesh, g.reference(), {}, cancelled), Error);
}

TEST(FinalSmoothing, ToleratesTriangles) {
    const Grid g = make(8, 8, on_plane);
    SurfaceMesh mesh = from_arrays(g.points, g.triangles);
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) mesh.info(Face(f)).patch = 0;
    distort(mesh, g, on_plane, 0.3);
    smooth_mesh(mesh, g.reference());
    EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace anisoquad
