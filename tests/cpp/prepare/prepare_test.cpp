#include "prepare/prepare.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"
#include "mesh/validate.h"

namespace anisoquad {
namespace {

struct Surface {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// An open cylinder as a CAD kernel tessellates it: one strip of `sides` long facets of the given height.
Surface strip_cylinder(int sides, int rings, double height) {
    Surface s;
    const double radius = 0.1;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < sides; ++i) {
            const double a = 2.0 * std::numbers::pi * i / sides;
            s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), height * j / rings);
        }
    }
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < sides; ++i) {
            const int a = j * sides + i;
            const int b = j * sides + (i + 1) % sides;
            s.triangles.push_back({a, b, b + sides});
            s.triangles.push_back({a, b + sides, a + sides});
        }
    }
    return s;
}

struct Prepared {
    SurfaceMesh mesh;
    PrepareResult result;
    Topology before;
    std::vector<Source> sources;
};

Prepared prepare(const Surface& s, std::vector<Source> sources = {}) {
    Prepared p;
    p.mesh = from_arrays(s.points, s.triangles);
    p.before = topology(p.mesh);
    find_features(p.mesh, sources, {});
    find_patches(p.mesh);
    std::vector<std::int32_t> patch;
    for (std::int32_t f = 0; f < p.mesh.face_slots(); ++f) patch.push_back(p.mesh.info(Face(f)).patch);
    const ReferenceSurface reference(s.points, s.triangles, patch);
    p.result = prepare_triangles(p.mesh, s.points, s.triangles, reference, sources);
    p.sources = std::move(sources);
    return p;
}

double smallest_shape(const SurfaceMesh& mesh) {
    double smallest = 1.0;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        const HalfEdge h = mesh.halfedge(Face(i));
        const Point& a = mesh.position(mesh.from(h));
        const Point& b = mesh.position(mesh.to(h));
        const Point& c = mesh.position(mesh.to(mesh.next(h)));
        const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        smallest = std::min(smallest, 2.0 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / edges);
    }
    return smallest;
}

TEST(PrepareTriangles, LongThinFacetsBecomeTrianglesThatCanHoldQuads) {
    const Surface s = strip_cylinder(24, 1, 1.0);
    const Prepared p = prepare(s);
    EXPECT_EQ(p.result.patches, 1);
    EXPECT_GT(p.result.triangles_after, p.result.triangles_before);
    EXPECT_TRUE(validate(p.mesh).empty());
    EXPECT_EQ(topology(p.mesh), p.before);
    EXPECT_GT(smallest_shape(p.mesh), 0.15);
    // On the cylinder between its facets' planes and the circle through their corners.
    for (std::int32_t i = 0; i < p.mesh.vertex_slots(); ++i) {
        if (p.mesh.is_deleted(Vertex(i))) continue;
        const Point& x = p.mesh.position(Vertex(i));
        EXPECT_NEAR(std::hypot(x.x(), x.y()), 0.1, 0.1 * (1.0 - std::cos(std::numbers::pi / 24)) + 1e-3);
    }
}

TEST(PrepareTriangles, GoodTrianglesAreLeftUntouched) {
    const Surface s = strip_cylinder(24, 40, 1.0);
    const Prepared p = prepare(s);
    EXPECT_EQ(p.result.patches, 0);
    EXPECT_EQ(p.mesh.face_count(), static_cast<std::int32_t>(s.triangles.size()));
    for (std::int32_t i = 0; i < p.mesh.vertex_slots(); ++i) {
        EXPECT_EQ(p.mesh.position(Vertex(i)), s.points[static_cast<std::size_t>(i)]);
    }
}

TEST(PrepareTriangles, SourcesGetTheNodesThatComeUpOnThem) {
    const Surface s = strip_cylinder(24, 1, 1.0);
    const Prepared p = prepare(s, {Source{{0, 24}, {{2, 0}}, Sides::both}});
    const auto& nodes = p.sources[0].vertices;
    EXPECT_EQ(nodes.front(), 0);
    EXPECT_EQ(nodes.back(), 24);
    EXPECT_GT(nodes.size(), 4U);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const HalfEdge h = p.mesh.find_halfedge(Vertex(nodes[i]), Vertex(nodes[i + 1]));
        ASSERT_TRUE(h.is_valid());
        EXPECT_TRUE(p.mesh.info(SurfaceMesh::edge(h)).source);
    }
}

}  // namespace
}  // namespace anisoquad
