#include "prepare/remesh.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

std::vector<char> everywhere(const SurfaceMesh& mesh) {
    return std::vector<char>(static_cast<std::size_t>(mesh.vertex_slots()), 1);
}

void set_sizes(SurfaceMesh& mesh, double size) {
    for (const Vertex v : vertices(mesh)) mesh.info(v).size = size;
}

/// Mean length of the edges that lie on no line.
double mean_free_length(const SurfaceMesh& mesh) {
    double sum = 0.0;
    int n = 0;
    for (const Edge e : edges(mesh)) {
        if (mesh.is_constrained(e)) continue;
        sum += mesh.length(e);
        ++n;
    }
    return sum / n;
}

/// Edge of the equilateral triangles whose pairs are as large as squares of the size.
double wanted_edge(double size) { return size * std::sqrt(2.0 / std::sqrt(3.0)); }

void expect_lines_kept(const Prepared& p) {
    for (const Vertex v : vertices(p.mesh)) {
        if (p.mesh.info(v).kind == NodeKind::interior) continue;
        ASSERT_GE(p.mesh.info(v).input, 0);
        EXPECT_EQ(p.mesh.position(v), p.shape.points[static_cast<std::size_t>(p.mesh.info(v).input)]);
    }
}

int constrained_edges(const SurfaceMesh& mesh) {
    int n = 0;
    for (const Edge e : edges(mesh)) n += mesh.is_constrained(e);
    return n;
}

TEST(Remesh, CanBeCancelledInItsMidst) {
    for (const int asked : {1, 3}) {
        Prepared p(shapes::grid(60, 60));
        set_sizes(p.mesh, 0.5);
        std::vector<char> zone = everywhere(p.mesh);
        int calls = 0;
        const Context context([&](std::string_view, double done) {
            EXPECT_EQ(done, 0.0);
            return ++calls < asked;
        });
        EXPECT_THROW(remesh_triangles(p.mesh, zone, p.reference, {.context = &context}), Error);
        EXPECT_EQ(calls, asked);
    }
}

TEST(Remesh, ApproachesTheWantedSize) {
    for (const double size : {0.5, 0.7, 1.6, 2.5}) {
        Prepared p(shapes::grid(20, 20));
        const int lines = constrained_edges(p.mesh);
        set_sizes(p.mesh, size);
        std::vector<char> zone = everywhere(p.mesh);
        const RemeshResult result = remesh_triangles(p.mesh, zone, p.reference, {.sweeps = 8});
        expect_sound(p);
        EXPECT_EQ(inverted_triangles(p), 0);
        EXPECT_NEAR(signed_area(p), 400.0, 1e-6);
        EXPECT_EQ(constrained_edges(p.mesh), lines);
        expect_lines_kept(p);
        EXPECT_GT(size < 1.0 ? result.splits : result.collapses, 0);
        EXPECT_GT(mean_free_length(p.mesh), 0.75 * wanted_edge(size));
        EXPECT_LT(mean_free_length(p.mesh), 1.25 * wanted_edge(size));
    }
}

TEST(Remesh, GradedSizesGiveGradedTriangles) {
    Prepared p(shapes::grid(24, 12));
    for (const Vertex v : vertices(p.mesh)) p.mesh.info(v).size = 0.6 + 0.06 * p.mesh.position(v).x();
    std::vector<char> zone = everywhere(p.mesh);
    remesh_triangles(p.mesh, zone, p.reference, {.sweeps = 8});
    expect_sound(p);
    double left = 0.0;
    double right = 0.0;
    int n_left = 0;
    int n_right = 0;
    for (const Edge e : edges(p.mesh)) {
        const HalfEdge h = M::halfedge(e);
        const double x = 0.5 * (p.mesh.position(p.mesh.from(h)).x() + p.mesh.position(p.mesh.to(h)).x());
        if (p.mesh.is_constrained(e)) continue;
        (x < 8.0 ? left : right) += x < 8.0 || x > 16.0 ? p.mesh.length(e) : 0.0;
        n_left += x < 8.0;
        n_right += x > 16.0;
    }
    EXPECT_NEAR(left / n_left / wanted_edge(0.84), 1.0, 0.25);
    EXPECT_NEAR(right / n_right / wanted_edge(1.8), 1.0, 0.25);
}

TEST(Remesh, StaysOnCurvedSurfaces) {
    for (const double size : {0.08, 0.25}) {
        Prepared p(shapes::sphere(40, 26));
        set_sizes(p.mesh, size);
        std::vector<char> zone = everywhere(p.mesh);
        remesh_triangles(p.mesh, zone, p.reference, {.deviation = 0.01});
        expect_sound(p);
        EXPECT_EQ(inverted_triangles(p), 0);
        for (const Vertex v : vertices(p.mesh)) EXPECT_NEAR(p.mesh.position(v).norm(), 1.0, 4e-3);
        EXPECT_NEAR(mean_free_length(p.mesh) / wanted_edge(size), 1.0, 0.25);
    }
}

TEST(Remesh, LinesInsideAndQuadsStay) {
    const auto line = path(8 * 21, 8 * 21 + 20, 1);
    Prepared p(shapes::grid(20, 20), {source(line)});
    const Vertex a(14 * 21 + 7);
    HalfEdge diagonal = p.mesh.find_halfedge(a, Vertex(a.index() + 22));
    if (!diagonal.is_valid()) diagonal = p.mesh.find_halfedge(Vertex(a.index() + 1), Vertex(a.index() + 21));
    const Face quad = dissolve_edge(p.mesh, M::edge(diagonal));
    set_sizes(p.mesh, 2.0);
    std::vector<char> zone = everywhere(p.mesh);
    remesh_triangles(p.mesh, zone, p.reference);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    expect_covered(p.mesh, line);
    expect_lines_kept(p);
    EXPECT_EQ(quad_count(p.mesh), 1);
    ASSERT_TRUE(p.mesh.is_quad(quad));
    for (const int node : {0, 1, 21, 22})
        EXPECT_EQ(p.mesh.position(Vertex(a.index() + node)), p.shape.points[static_cast<std::size_t>(a.index() + node)]);
}

TEST(Remesh, OnlyTheZoneChanges) {
    Prepared p(shapes::grid(20, 20));
    set_sizes(p.mesh, 0.5);
    std::vector<char> none(static_cast<std::size_t>(p.mesh.vertex_slots()), 0);
    const RemeshResult nothing = remesh_triangles(p.mesh, none, p.reference);
    EXPECT_EQ(nothing.splits + nothing.collapses + nothing.flips + nothing.moves, 0);
    std::vector<char> zone = none;
    for (const Vertex v : vertices(p.mesh)) zone[static_cast<std::size_t>(v.index())] = p.mesh.position(v).x() < 8.0;
    remesh_triangles(p.mesh, zone, p.reference);
    expect_sound(p);
    for (std::int32_t i = 0; i < 441; ++i) {
        const Point& at = p.shape.points[static_cast<std::size_t>(i)];
        if (at.x() < 8.5) continue;
        ASSERT_FALSE(p.mesh.is_deleted(Vertex(i)));
        EXPECT_EQ(p.mesh.position(Vertex(i)), at);
    }
    EXPECT_GE(static_cast<std::int32_t>(zone.size()), p.mesh.vertex_slots());
}

TEST(Remesh, GoodTrianglesAreLeftAlone) {
    Prepared p(shapes::grid(12, 12));
    set_sizes(p.mesh, 1.0);
    std::vector<char> zone = everywhere(p.mesh);
    const RemeshResult result = remesh_triangles(p.mesh, zone, p.reference);
    EXPECT_EQ(result.splits, 0);
    EXPECT_EQ(result.collapses, 0);
    EXPECT_EQ(p.mesh.vertex_count(), 169);
}

TEST(Remesh, SizeAndPlaceDoNotMatter) {
    const auto remeshed = [](double scale, const Point& offset) {
        Prepared p(shapes::placed(shapes::cylinder(30, 12), scale, offset));
        set_sizes(p.mesh, 0.3 * scale);
        std::vector<char> zone = everywhere(p.mesh);
        remesh_triangles(p.mesh, zone, p.reference);
        return p.mesh.face_count();
    };
    const std::int32_t count = remeshed(1.0, Point::Zero());
    EXPECT_EQ(remeshed(1.0 / 1024.0, Point::Zero()), count);
    EXPECT_NEAR(remeshed(1.0, Point(100, 0, 0)), count, 0.02 * count);  // rounding may decide ties otherwise
}

TEST(SwapTowardsDelaunay, LeavesNoEdgeWhoseOppositeAnglesSumToMoreThanPi) {
    shapes::Shape shape = shapes::grid(12, 10);
    for (Point& q : shape.points)
        q += Point(0.55 * q.y() + 0.2 * std::sin(3.0 * q.x()), 0.2 * std::sin(5.0 * q.y() + q.x()), 0.0);
    Prepared p(shape, {source(path(5 * 13 + 2, 5 * 13 + 9, 1))});
    EXPECT_GT(swap_towards_delaunay(p.mesh, everywhere(p.mesh), p.reference), 0);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    expect_covered(p.mesh, path(5 * 13 + 2, 5 * 13 + 9, 1));
    const auto opposite = [&](HalfEdge h) {
        const Point& apex = p.mesh.position(p.mesh.to(p.mesh.next(h)));
        const Eigen::Vector3d a = p.mesh.position(p.mesh.from(h)) - apex;
        const Eigen::Vector3d b = p.mesh.position(p.mesh.to(h)) - apex;
        return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    for (const Edge e : edges(p.mesh)) {
        if (p.mesh.is_constrained(e)) continue;
        EXPECT_LE(opposite(M::halfedge(e, 0)) + opposite(M::halfedge(e, 1)), std::numbers::pi + 1e-5);
    }
    EXPECT_EQ(swap_towards_delaunay(p.mesh, everywhere(p.mesh), p.reference), 0);
}

}  // namespace
}  // namespace anisoquad
