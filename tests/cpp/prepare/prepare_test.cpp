#include "prepare/prepare.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"
#include "mesh/validate.h"
#include "prepare/remesh.h"
#include "prepare/triangle_shape.h"
#include "strip_cylinder.h"

namespace anisoquad {
namespace {

struct Prepared {
    SurfaceMesh mesh;
    PrepareResult result;
    Topology before;
    std::vector<Source> sources;
};

Prepared prepare(const Surface& s, std::vector<Source> sources = {}, const Options& options = {}) {
    Prepared p;
    p.mesh = from_arrays(s.points, s.triangles);
    p.before = topology(p.mesh);
    const std::vector<FeatureLine> lines = find_features(p.mesh, sources, {});
    const ReferenceLines reference_lines(p.mesh, lines);
    find_patches(p.mesh);
    std::vector<std::int32_t> patch;
    for (std::int32_t f = 0; f < p.mesh.face_slots(); ++f) patch.push_back(p.mesh.info(Face(f)).patch);
    const ReferenceSurface reference(s.points, s.triangles, patch);
    p.result = prepare_triangles(p.mesh, {s.points, s.triangles, reference, lines, reference_lines}, sources, options);
    p.sources = std::move(sources);
    return p;
}

double smallest_shape(const SurfaceMesh& mesh) {
    double smallest = 1.0;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        const HalfEdge h = mesh.halfedge(Face(i));
        smallest = std::min(smallest, triangle_shape(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)),
                                                     mesh.position(mesh.to(mesh.next(h)))));
    }
    return smallest;
}

/// Mean edge length between triangles, over that of the triangles that stand for squares of the size.
double mean_edge_over(const SurfaceMesh& mesh, double size) {
    double sum = 0.0;
    int n = 0;
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_deleted(Edge(i))) continue;
        sum += mesh.length(Edge(i));
        ++n;
    }
    return sum / n / (kTriangleEdge * size);
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

TEST(PrepareTriangles, AnAskedSizeIsReachedFromFinerAndFromCoarserTriangles) {
    const Surface s = strip_cylinder(24, 40, 1.0);
    Options options;
    options.curvature_angle = 0.0;
    for (const double size : {0.012, 0.05}) {
        options.size = size;
        const Prepared p = prepare(s, {}, options);
        EXPECT_EQ(p.result.patches, 1);
        EXPECT_NEAR(mean_edge_over(p.mesh, size), 1.0, 0.15) << size;
        EXPECT_GT(smallest_shape(p.mesh), 0.3) << size;
        EXPECT_EQ(topology(p.mesh), p.before);
    }
}

TEST(PrepareTriangles, LinesGrowFromEdgesThatAnotherLinesShapeKeepsShort) {
    // A long plate whose lower side is an arc of short edges.
    constexpr int kArc = 24;
    Surface s;
    for (int i = 0; i <= kArc; ++i) {
        const double angle = std::numbers::pi * (4.0 + 1.0 * i / kArc) / 3.0;
        s.points.emplace_back(0.5 + std::cos(angle), std::sqrt(0.75) + std::sin(angle), 0.0);
    }
    s.points.insert(s.points.end(), {{0.0, 4.0, 0.0}, {1.0, 4.0, 0.0}});
    for (int i = 0; i < kArc; ++i) s.triangles.push_back({i, i + 1, kArc + 1});
    s.triangles.push_back({kArc, kArc + 2, kArc + 1});
    Options options;
    options.size = 0.5;
    options.growth = 1.3;
    const Prepared p = prepare(s, {}, options);
    double shortest_on_arc = 1.0;
    double on_side = 0.0;
    for (const HalfEdge h : p.mesh.outgoing(Vertex(0))) {
        if (!p.mesh.is_boundary(SurfaceMesh::edge(h))) continue;
        const bool is_side = p.mesh.position(p.mesh.to(h)).x() < 1e-9;
        (is_side ? on_side : shortest_on_arc) = p.mesh.length(h);
    }
    EXPECT_LT(shortest_on_arc, 0.2);
    EXPECT_LT(on_side, 2.0 * shortest_on_arc);
    EXPECT_GT(on_side, 0.5 * shortest_on_arc);
}

TEST(PrepareTriangles, SizesGivenPerVertexGradeTheTriangles) {
    const Surface s = strip_cylinder(24, 40, 1.0);
    Options options;
    options.curvature_angle = 0.0;
    for (const Point& p : s.points) options.vertex_size.push_back(p.z() < 0.5 ? 0.01 : 0.04);
    const Prepared p = prepare(s, {}, options);
    double low = 0.0, high = 0.0;
    int lows = 0, highs = 0;
    for (std::int32_t i = 0; i < p.mesh.edge_slots(); ++i) {
        if (p.mesh.is_deleted(Edge(i))) continue;
        const double z = p.mesh.position(p.mesh.from(SurfaceMesh::halfedge(Edge(i)))).z();
        if (z < 0.4) low += p.mesh.length(Edge(i)), ++lows;
        if (z > 0.9) high += p.mesh.length(Edge(i)), ++highs;
    }
    EXPECT_NEAR(low / lows, 0.01, 0.003);
    EXPECT_NEAR(high / highs, 0.04, 0.01);
}

TEST(PrepareTriangles, StripsFarThinnerThanTheSizeLeaveNoSliversAlongASource) {
    const Surface s = strip_nose();
    for (const double size : {0.01, 0.015, 0.03, 0.05}) {
        Options options;
        options.size = size;
        const Prepared p = prepare(s, {Source{{0, 1}, passes_for_anisotropy(16), Sides::both}}, options);
        EXPECT_TRUE(validate(p.mesh).empty());
        EXPECT_EQ(topology(p.mesh), p.before);
        EXPECT_GT(smallest_shape(p.mesh), 0.05) << size;
    }
}

TEST(PrepareTriangles, NothingIsDoneWhereItIsSwitchedOff) {
    const Surface s = strip_cylinder(24, 1, 1.0);
    Options options;
    options.prepare = false;
    const Prepared p = prepare(s, {}, options);
    EXPECT_EQ(p.result.patches, 0);
    EXPECT_EQ(p.mesh.face_count(), static_cast<std::int32_t>(s.triangles.size()));
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
