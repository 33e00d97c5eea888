#include "anisotropy/geodesic_trace.h"

#include <gtest/gtest.h>

#include <numbers>

#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

HalfEdge edge(const SurfaceMesh& mesh, int a, int b) { return mesh.find_halfedge(Vertex(a), Vertex(b)); }

/// The point lies in the triangle, up to rounding.
void expect_inside(const SurfaceMesh& mesh, Face f, const Point& p) {
    const Eigen::Vector3d n = doubled_area(mesh, f);
    for (const HalfEdge h : mesh.halfedges(f)) {
        const Point& a = mesh.position(mesh.from(h));
        EXPECT_GE((mesh.position(mesh.to(h)) - a).cross(p - a).dot(n), -1e-9 * n.squaredNorm());
    }
}

TEST(GeodesicTrace, IsAStraightLineOnAPlane) {
    Prepared p(shapes::grid(12, 10));
    for (const double angle : {0.3, 0.6, 1.0, 1.3, 2.0, 2.7}) {
        for (const double length : {0.2, 1.0, 3.7}) {
            const TraceEnd end = trace_geodesic(p.mesh, edge(p.mesh, 5, 6), angle, length);
            EXPECT_FALSE(end.blocked);
            EXPECT_DOUBLE_EQ(end.length, length);
            const Point expected(6.0 - length * std::cos(angle), length * std::sin(angle), 0.0);
            EXPECT_LT((end.position - expected).norm(), 1e-9);
            expect_inside(p.mesh, end.face, end.position);
        }
    }
}

TEST(GeodesicTrace, EndsAtTheBoundary) {
    Prepared p(shapes::grid(12, 10));
    for (const double angle : {0.9, 1.3, 2.0}) {
        const TraceEnd end = trace_geodesic(p.mesh, edge(p.mesh, 5, 6), angle, 100.0);
        EXPECT_TRUE(end.blocked);
        const double way = std::min(10.0 / std::sin(angle), angle < std::numbers::pi / 2 ? 6.0 / std::cos(angle) : 1e9);
        EXPECT_NEAR(end.length, way, 1e-9);
        EXPECT_LT((end.position - Point(6.0 - way * std::cos(angle), way * std::sin(angle), 0.0)).norm(), 1e-9);
        EXPECT_NEAR(end.incidence, way < 10.0 / std::sin(angle) ? std::cos(angle) : std::sin(angle), 1e-9);
    }
}

TEST(GeodesicTrace, EndsAtALineAndAtTheFirstEdge) {
    Prepared p(shapes::grid(12, 10), {source(path(4 * 13, 4 * 13 + 12, 1))});
    const TraceEnd line = trace_geodesic(p.mesh, edge(p.mesh, 5, 6), 1.4, 9.0);
    EXPECT_TRUE(line.blocked);
    EXPECT_NEAR(line.position.y(), 4.0, 1e-9);
    Prepared flat(shapes::grid(4, 1));
    const TraceEnd first = trace_geodesic(flat.mesh, edge(flat.mesh, 1, 2), 1.4, 9.0);
    EXPECT_TRUE(first.blocked);
    EXPECT_NEAR(first.length, 1.0 / std::sin(1.4), 1e-9);
    expect_inside(flat.mesh, first.face, first.position);
}

TEST(GeodesicTrace, IsStraightOnTheUnrolledCylinder) {
    const int n = 40;
    Prepared p(shapes::cylinder(n, 20, 1.0, 3.0));
    const double cell = 2.0 * std::sin(std::numbers::pi / n);  // width of a facet: the band is a prism, which unrolls
    for (const double angle : {0.7, 1.0, 2.2, 2.6}) {
        for (const double length : {0.3, 1.1, 2.4}) {
            const TraceEnd end = trace_geodesic(p.mesh, edge(p.mesh, 19, 20), angle, length);
            EXPECT_FALSE(end.blocked);
            const double turns = 20.0 - length * std::cos(angle) / cell;
            const int facet = static_cast<int>(std::floor(turns));
            const auto corner = [&](int i) { return p.shape.points[static_cast<std::size_t>((i + n) % n)]; };
            Point expected = corner(facet) + (turns - facet) * (corner(facet + 1) - corner(facet));
            expected.z() = length * std::sin(angle);
            EXPECT_LT((end.position - expected).norm(), 1e-9);
            EXPECT_DOUBLE_EQ(end.length, length);
        }
    }
}

TEST(GeodesicTrace, SizeAndPlaceDoNotMatter) {
    const shapes::Shape shape = shapes::sphere(30, 20);
    Prepared p(shape, {source(path(185, 200, 1))});
    const double scale = 1e-5;
    Prepared q(shapes::placed(shape, scale, Point(0.02, 0, 0)), {source(path(185, 200, 1))});
    for (const double angle : {0.8, 1.5, 2.4}) {
        const TraceEnd a = trace_geodesic(p.mesh, edge(p.mesh, 190, 191), angle, 0.6);
        const TraceEnd b = trace_geodesic(q.mesh, edge(q.mesh, 190, 191), angle, 0.6 * scale);
        EXPECT_EQ(a.face, b.face);
        EXPECT_LT((scale * a.position + Point(0.02, 0, 0) - b.position).norm(), 1e-8 * scale);
        EXPECT_NEAR(a.position.norm(), 1.0, 0.02);
    }
}

}  // namespace
}  // namespace anisoquad
