#include "input/needles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

constexpr std::int32_t kMiddle = 12;
constexpr std::int32_t kBeside = 25;
constexpr std::int32_t kAbove = 17;

/// A square of diagonal 1 of 4 × 4 cells, whose middle point is two: (2, 2), with the cells on its left, and another one
/// beside it, with those on its right. Two needles fill the gap.
shapes::Shape square_with_needles(double length) {
    const double cell = std::sqrt(0.5) / 4.0;
    shapes::Shape shape = shapes::grid(4, 4, cell, cell);
    for (auto& triangle : shape.triangles) {
        double x = 0.0;
        for (const std::int32_t v : triangle) x += shape.points[static_cast<std::size_t>(v)].x() / 3.0;
        if (x < 2.0 * cell) continue;
        for (std::int32_t& v : triangle) v = v == kMiddle ? kBeside : v;
    }
    shape.points.emplace_back(2.0 * cell + length, 2.0 * cell, 0.0);
    shape.triangles.push_back({kMiddle, kBeside, kAbove});
    shape.triangles.push_back({kBeside, kMiddle, 7});
    return shape;
}

TEST(Needles, HaveTheirShortEdgeCollapsed) {
    SurfaceMesh mesh = square_with_needles(1e-5).mesh();
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 1);
    EXPECT_EQ(mesh.face_count(), 32);
    EXPECT_EQ(mesh.vertex_count(), 25);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 0);
}

TEST(Needles, AreThinnerThanAHair) {
    SurfaceMesh mesh = square_with_needles(2e-4).mesh();
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 0);
    EXPECT_EQ(collapse_needles(mesh, 10.0, {}, {}), 1) << "beside a larger model it is one";
}

TEST(Needles, AreNotSmallTrianglesOfAGoodShape) {
    SurfaceMesh mesh = shapes::grid(4, 4, 1e-5, 1e-5).mesh();
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 0);
}

TEST(Needles, VerticesThatTheUserNamedStay) {
    for (const std::int32_t named : {kMiddle, kBeside}) {
        SurfaceMesh mesh = square_with_needles(1e-5).mesh();
        EXPECT_EQ(collapse_needles(mesh, 1.0, std::vector<Source>{{{named, kAbove}, {}, Sides::both}}, {}), 1);
        EXPECT_FALSE(mesh.is_deleted(Vertex(named)));
    }
    SurfaceMesh mesh = square_with_needles(1e-5).mesh();
    Options options;
    options.feature_edges = {{kMiddle, kAbove}, {7, kBeside}};
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, options), 0);
}

/// West of the middle point and east of the other the surface falls off from two ridges each.
TEST(Needles, KeepTwoFeatureLinesApart) {
    shapes::Shape shape = square_with_needles(1e-5);
    shape.points[11].z() -= 0.3;
    shape.points[13].z() -= 0.3;
    SurfaceMesh mesh = shape.mesh();
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 0);
    Options options;
    options.feature_angle = 180.0;
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, options), 1) << "no edge is a feature";
}

/// As across a blunt trailing edge.
TEST(Needles, OfAStripStay) {
    const double cell = std::sqrt(0.5) / 4.0;
    shapes::Shape shape = shapes::grid(4, 4, cell, cell);
    for (std::size_t j = 0; j <= 4; ++j) {
        for (std::size_t i = 3; i <= 4; ++i) shape.points[5 * j + i].x() -= cell - 1e-5;
    }
    SurfaceMesh mesh = shape.mesh();
    EXPECT_EQ(collapse_needles(mesh, 1.0, {}, {}), 0);
}

TEST(Needles, NoTriangleIsTurnedOver) {
    shapes::Shape shape = square_with_needles(1e-5);
    // A corner so near that either end of the needle's edge would cross it.
    shape.points[13] = shape.points[kBeside] + Point(4e-6, 0, 0);
    shape.points[11] = shape.points[kMiddle] - Point(4e-6, 0, 0);
    SurfaceMesh mesh = shape.mesh();
    const auto total = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double areas = 0.0;
        for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
            if (mesh.is_deleted(Face(i))) continue;
            const HalfEdge h = mesh.halfedge(Face(i));
            const Eigen::Vector3d area = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h)))
                                             .cross(mesh.position(mesh.to(mesh.next(h))) - mesh.position(mesh.from(h)));
            sum += area;
            areas += area.norm();
        }
        return areas - sum.norm();
    };
    collapse_needles(mesh, 1.0, {}, {});
    EXPECT_NEAR(total(), 0.0, 1e-12);
    EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace anisoquad
