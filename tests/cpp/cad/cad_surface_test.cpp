#include "cad/cad_surface.h"

#include <gtest/gtest.h>

#include <thread>

#include "cad/smooth_edges.h"
#include "cad/triangulate.h"
#include "cad_shapes.h"
#include "errors.h"
#include "quad_mesh.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

struct Linked {
    std::shared_ptr<const CadShape> shape;
    Triangulation mesh;
    std::shared_ptr<const MeshLink> link;
    std::unique_ptr<CadSurface> surface;

    explicit Linked(CadShape made, double smooth = 0.0)
        : shape(std::make_shared<const CadShape>(std::move(made))), mesh(triangulate(*shape)) {
        link = std::make_shared<const MeshLink>(link_mesh(*shape, mesh.points, mesh.triangles));
        const std::vector<char> joined = smooth > 0.0 ? smooth_edges(*shape, smooth) : std::vector<char>();
        surface = std::make_unique<CadSurface>(shape, link, mesh.triangles, joined);
    }

    QuadMeshResult quads(double size) const {
        Options options;
        options.size = size;
        options.feature_edges = surface->feature_edges();
        options.validate = true;
        return quad_mesh(link->points, mesh.triangles, {}, options, no_context(), surface.get());
    }
};

/// Distance of a point from a cylinder of the radius 1 and the height 2 on the plane z = 0.
double off_cylinder(const Vector3d& p) {
    const double radius = p.head<2>().norm();
    const double side = std::hypot(radius - 1.0, std::max({0.0, -p.z(), p.z() - 2.0}));
    const double caps = std::min(std::abs(p.z()), std::abs(p.z() - 2.0));
    return std::min(side, std::hypot(caps, std::max(0.0, radius - 1.0)));
}

TEST(CadSurface, AllNodesOfAQuadMeshLieOnTheShape) {
    const Linked cylinder(shapes::cylinder(1.0, 2.0));
    const QuadMeshResult result = cylinder.quads(0.15);
    EXPECT_EQ(result.report.patches, 3);
    EXPECT_EQ(result.report.inverted, 0);
    double largest = 0.0;
    for (const Vector3d& p : result.points) largest = std::max(largest, off_cylinder(p));
    EXPECT_LT(largest, 1e-12);
    ASSERT_EQ(result.quad_facet.size(), result.quads.size());
    for (std::size_t q = 0; q < result.quads.size(); ++q) {
        const CadFace& face = cylinder.shape->face(cylinder.link->facet_face[static_cast<std::size_t>(result.quad_facet[q])]);
        for (const std::int32_t v : result.quads[q]) {
            const Vector3d& p = result.points[static_cast<std::size_t>(v)];
            if (face.range[0].periodic) {
                EXPECT_NEAR(p.head<2>().norm(), 1.0, 1e-12);
            }
        }
    }
    ASSERT_EQ(result.line_edge_input.size(), result.line_edges.size());
    for (const auto& [a, b] : result.line_edge_input) EXPECT_GE(cylinder.surface->edge_of(a, b), 0);
}

TEST(CadSurface, TrianglesAloneLeaveNodesOffTheShape) {
    const Linked cylinder(shapes::cylinder(1.0, 2.0));
    Options options;
    options.size = 0.15;
    options.feature_edges = cylinder.surface->feature_edges();
    double largest = 0.0;
    for (const Vector3d& p : quad_mesh(cylinder.link->points, cylinder.mesh.triangles, {}, options).points)
        largest = std::max(largest, off_cylinder(p));
    EXPECT_GT(largest, 1e-8);
}

TEST(CadSurface, FacesThatJoinSmoothlyCanBeOnePatch) {
    const Linked stadium(shapes::stadium(), 1.0);
    const QuadMeshResult result = stadium.quads(0.3);
    EXPECT_EQ(result.report.patches, 3);
    EXPECT_EQ(result.report.inverted, 0);
    for (const Vector3d& p : result.points) {
        const double x = std::clamp(p.x(), 0.0, 4.0);
        const double radius = std::hypot(p.x() - x, p.y() - 1.0);
        const bool on_caps = std::min(std::abs(p.z()), std::abs(p.z() - 1.0)) < 1e-12;
        EXPECT_TRUE(std::abs(radius - 1.0) < 1e-12 || (on_caps && radius < 1.0)) << p.transpose();
    }
    const Linked apart(shapes::stadium());
    EXPECT_EQ(apart.quads(0.3).report.patches, 6);
}

TEST(CadSurface, GivesTheSameFromSeveralThreads) {
    const Linked wavy(shapes::wavy());
    std::vector<TargetPlace> places;
    std::vector<Vector3d> points;
    for (std::size_t f = 0; f < wavy.mesh.triangles.size(); ++f) {
        places.push_back({static_cast<std::int32_t>(f), Vector3d::Constant(1.0 / 3.0), {-1, -1}, 0.0});
        Vector3d middle = Vector3d::Zero();
        for (const std::int32_t v : wavy.mesh.triangles[f]) middle += wavy.mesh.points[static_cast<std::size_t>(v)] / 3.0;
        points.push_back(middle);
    }
    std::vector<Vector3d> alone = points;
    wavy.surface->project(places, alone);
    std::vector<std::vector<Vector3d>> together(4, points);
    std::vector<std::thread> threads;
    for (auto& own : together) threads.emplace_back([&] { wavy.surface->project(places, own); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& own : together) EXPECT_EQ(own, alone);
}

TEST(CadSurface, LeavesRepairAlone) {
    const Linked box(shapes::box());
    Options options;
    options.repair = true;
    EXPECT_THROW(quad_mesh(box.link->points, box.mesh.triangles, {}, options, no_context(), box.surface.get()), Error);
}

}  // namespace
}  // namespace anisoquad::cad
