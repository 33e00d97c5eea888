#include "picking/geodesic_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "picking/best_path.h"
#include "picking/intrinsic_triangulation.h"
#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

std::vector<Point> polyline(const SurfaceMesh& mesh, const std::vector<GeodesicPiece>& pieces) {
    std::vector<Point> line{mesh.position(pieces.front().from)};
    for (const GeodesicPiece& piece : pieces) {
        for (const Crossing& c : piece.crossings) {
            const HalfEdge h = SurfaceMesh::halfedge(c.edge);
            line.push_back((1.0 - c.t) * mesh.position(mesh.from(h)) + c.t * mesh.position(mesh.to(h)));
        }
        line.push_back(mesh.position(piece.to));
    }
    return line;
}

double length(const std::vector<Point>& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += (line[i + 1] - line[i]).norm();
    return sum;
}

TEST(IntrinsicTriangulation, FlipsKeepAnglesAndLengths) {
    const SurfaceMesh mesh = shapes::sphere(16, 10).mesh();
    IntrinsicTriangulation t(mesh);
    const HalfEdge h = mesh.find_halfedge(Vertex(20), Vertex(37)).is_valid() ? mesh.find_halfedge(Vertex(20), Vertex(37))
                                                                             : mesh.find_halfedge(Vertex(21), Vertex(36));
    ASSERT_TRUE(h.is_valid());
    const double before = t.length(h);
    const double direction = t.direction(h);
    t.flip(h);
    EXPECT_NE(t.length(h), before);
    t.flip(h);
    EXPECT_NEAR(t.length(h), before, 1e-12);
    const double turn = std::remainder(t.direction(h) - direction, t.total_angle(t.from(h)));
    // Two flips turn the edge round: it now leaves the other end.
    EXPECT_TRUE(std::abs(turn) < 1e-9 || t.from(h) != mesh.from(h));
    for (const HalfEdge x : {h, IntrinsicTriangulation::twin(h)}) {
        EXPECT_NEAR(t.angle(x) + t.angle(t.next(x)) + t.angle(t.prev(x)), std::numbers::pi, 1e-12);
    }
}

TEST(GeodesicPath, IsTheStraightLineOnAPlane) {
    const PickSurface surface = shapes::pick_surface(shapes::unstructured(16));
    for (const auto& [from, to] : {std::pair(5 * 17 + 2, 11 * 17 + 14), std::pair(8 * 17 + 1, 8 * 17 + 15), std::pair(40, 200)}) {
        const std::vector<std::int32_t> path = best_path(surface, from, to);
        const auto pieces = geodesic_path(surface.mesh, shapes::vertices(path));
        ASSERT_TRUE(pieces);
        const std::vector<Point> line = polyline(surface.mesh, *pieces);
        const Point& a = surface.points[static_cast<std::size_t>(from)];
        const Point& b = surface.points[static_cast<std::size_t>(to)];
        EXPECT_NEAR(length(line), (b - a).norm(), 1e-6);
        EXPECT_LT(length(line), shapes::length(surface.points, path));
        for (const Point& p : line) EXPECT_LT((p - a).cross(b - a).norm() / (b - a).norm(), 1e-3);
    }
}

TEST(GeodesicPath, UnrollsTheCylinder) {
    const int n = 24;
    const shapes::Shape shape = shapes::cylinder(n, 12, 1.0, 4.0);
    const PickSurface surface = shapes::pick_surface(shape);
    const std::vector<std::int32_t> path = best_path(surface, 2 * n + 1, 10 * n + 8);
    const auto pieces = geodesic_path(surface.mesh, shapes::vertices(path));
    ASSERT_TRUE(pieces);
    const double across = 7.0 * 2.0 * std::sin(std::numbers::pi / n);
    EXPECT_NEAR(length(polyline(surface.mesh, *pieces)), std::hypot(across, 8.0 * 4.0 / 12.0), 1e-6);
}

TEST(GeodesicPath, IsNeverLongerOnACurvedSurface) {
    const shapes::Shape shape = shapes::sphere(30, 20);
    const PickSurface surface = shapes::pick_surface(shape);
    const std::vector<std::int32_t> path = best_path(surface, 5 * 30 + 2, 13 * 30 + 14);
    const auto pieces = geodesic_path(surface.mesh, shapes::vertices(path));
    ASSERT_TRUE(pieces);
    const double shortened = length(polyline(surface.mesh, *pieces));
    EXPECT_LT(shortened, shapes::length(surface.points, path));
    const Point a = surface.points[5 * 30 + 2].normalized();
    const Point b = surface.points[13 * 30 + 14].normalized();
    EXPECT_NEAR(shortened, std::acos(a.dot(b)), 0.03);
}

TEST(GeodesicPath, AStraightPathStaysAMeshPath) {
    const PickSurface surface = shapes::pick_surface(shapes::grid(12, 10));
    const std::vector<std::int32_t> path = best_path(surface, 5 * 13 + 2, 5 * 13 + 9);
    const auto pieces = geodesic_path(surface.mesh, shapes::vertices(path));
    ASSERT_TRUE(pieces);
    EXPECT_EQ(pieces->size(), path.size() - 1);
    for (const GeodesicPiece& piece : *pieces) EXPECT_TRUE(piece.crossings.empty());
}

}  // namespace
}  // namespace anisoquad
