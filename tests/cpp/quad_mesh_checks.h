#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "quad_mesh.h"
#include "quality/metrics.h"
#include "stages.h"

/// What every result of the whole way has to be.
namespace anisoquad {

using Pair = std::pair<std::int32_t, std::int32_t>;

inline QuadMeshResult meshed(const shapes::Shape& shape, const std::vector<Source>& sources = {}, const Options& options = {}) {
    return quad_mesh(shape.points, shape.triangles, sources, options);
}

/// Directed edges of the faces; each must occur once.
template <class Faces>
std::set<Pair> directed_edges(const Faces& faces) {
    std::set<Pair> edges;
    for (const auto& f : faces) {
        for (std::size_t k = 0; k < f.size(); ++k) {
            EXPECT_TRUE(edges.insert({f[k], f[(k + 1) % f.size()]}).second) << "an edge with two faces on one side";
        }
    }
    return edges;
}

template <class Faces>
int euler_characteristic(const Faces& faces) {
    std::set<std::int32_t> nodes;
    for (const auto& f : faces) nodes.insert(f.begin(), f.end());
    std::set<Pair> edges;
    for (const auto& [a, b] : directed_edges(faces)) edges.insert(std::minmax(a, b));
    return static_cast<int>(nodes.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
}

template <class Faces>
int boundary_loops(const Faces& faces) {
    const std::set<Pair> edges = directed_edges(faces);
    std::map<std::int32_t, std::int32_t> next;
    for (const auto& [a, b] : edges) {
        if (!edges.contains({b, a})) next[a] = b;
    }
    int loops = 0;
    while (!next.empty()) {
        ++loops;
        for (auto at = next.begin(); at != next.end();) {
            const std::int32_t to = at->second;
            next.erase(at);
            at = next.find(to);
        }
    }
    return loops;
}

inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const double t = std::clamp((b - a).dot(p - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (a + t * (b - a) - p).norm();
}

inline double diagonal(const shapes::Shape& shape) {
    Point low = shape.points[0];
    Point high = shape.points[0];
    for (const Point& p : shape.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (high - low).norm();
}

/// All arrays agree with each other, and with the input where they say so.
inline void expect_consistent(const shapes::Shape& shape, const QuadMeshResult& result) {
    const std::size_t quads = result.quads.size();
    ASSERT_GT(quads, 0u);
    for (const auto* field : {&result.row, &result.pass, &result.source, &result.patch}) ASSERT_EQ(field->size(), quads);
    ASSERT_EQ(result.node_line.size(), result.points.size());
    ASSERT_EQ(result.node_input.size(), result.points.size());
    std::set<std::int32_t> used;
    for (std::size_t q = 0; q < quads; ++q) {
        const std::set<std::int32_t> nodes(result.quads[q].begin(), result.quads[q].end());
        ASSERT_EQ(nodes.size(), 4u);
        ASSERT_GE(*nodes.begin(), 0);
        ASSERT_LT(*nodes.rbegin(), static_cast<std::int32_t>(result.points.size()));
        used.insert(nodes.begin(), nodes.end());
        EXPECT_EQ(result.row[q] > 0, result.source[q] >= 0);
        EXPECT_EQ(result.row[q] > 0, result.pass[q] > 0);
        EXPECT_GE(result.patch[q], 0);
        EXPECT_LT(result.patch[q], result.report.patches);
    }
    EXPECT_EQ(used.size(), result.points.size());
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        EXPECT_TRUE(result.points[i].allFinite());
        if (result.node_input[i] < 0) continue;
        EXPECT_EQ(result.points[i], shape.points[static_cast<std::size_t>(result.node_input[i])]);
    }
    EXPECT_EQ(result.report.quads, static_cast<std::int32_t>(quads));
    EXPECT_EQ(result.report.triangles_left, 0);
    EXPECT_EQ(result.report.inverted, 0);
    EXPECT_EQ(result.report.triangles_in, static_cast<std::int32_t>(shape.triangles.size()));
    EXPECT_EQ(result.report.euler_in, result.report.euler_out);
    for (const std::string& warning : result.report.warnings) ADD_FAILURE() << warning;
}

/// No quad lies upside down or folded on the input surface.
inline void expect_oriented(const shapes::Shape& shape, const QuadMeshResult& result) {
    const ReferenceSurface reference(shape.points, shape.triangles);
    int inverted = 0;
    for (const auto& q : result.quads) {
        const auto p = [&](std::size_t k) -> const Point& { return result.points[static_cast<std::size_t>(q[k])]; };
        const SurfacePoint under = reference.closest(0.25 * (p(0) + p(1) + p(2) + p(3)));
        inverted += scaled_jacobian(p(0), p(1), p(2), p(3), reference.facet_normal(under.facet)) <= 0.0;
    }
    EXPECT_EQ(inverted, 0);
}

/// Boundary and features of the input (turn above 40°, and the given paths) are covered by line_edges, which are edges of quads.
inline void expect_lines_covered(const shapes::Shape& shape, const QuadMeshResult& result, const std::vector<Source>& sources,
                                 double tolerance) {
    const std::set<Pair> edges = directed_edges(result.quads);
    const auto at = [&](std::int32_t i) -> const Point& { return result.points[static_cast<std::size_t>(i)]; };
    std::set<Pair> covered;
    for (const auto& [a, b, line] : result.line_edges) {
        EXPECT_TRUE(edges.contains({a, b}) || edges.contains({b, a}));
        EXPECT_GE(line, 0);
        EXPECT_LT(line, result.report.feature_lines);
        covered.insert(std::minmax(a, b));
    }
    for (const auto& [a, b] : edges)
        EXPECT_TRUE(edges.contains({b, a}) || covered.contains(std::minmax(a, b))) << "a boundary edge on no line";

    SurfaceMesh mesh = shape.mesh();
    find_features(mesh, sources, {});
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (mesh.info(Edge(e)).line < 0) continue;
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        for (const double t : {0.0, 0.3, 0.5}) {
            const Point p = (1.0 - t) * mesh.position(mesh.from(h)) + t * mesh.position(mesh.to(h));
            double nearest = 1e300;
            for (const auto& [a, b, line] : result.line_edges) nearest = std::min(nearest, distance_to_segment(p, at(a), at(b)));
            ASSERT_LE(nearest, tolerance * diagonal(shape)) << "at " << p.transpose();
        }
    }
}

inline void expect_good(const shapes::Shape& shape, const QuadMeshResult& result, const std::vector<Source>& sources = {},
                        double tolerance = 1e-9) {
    expect_consistent(shape, result);
    if (testing::Test::HasFatalFailure()) return;
    EXPECT_EQ(euler_characteristic(result.quads), euler_characteristic(shape.triangles));
    EXPECT_EQ(boundary_loops(result.quads), boundary_loops(shape.triangles));
    expect_oriented(shape, result);
    expect_lines_covered(shape, result, sources, tolerance);
}

inline shapes::Shape plane_with_holes() {
    return shapes::grid_with_holes(
        24, 18, [](int i, int j) { return !((i >= 4 && i < 8 && j >= 4 && j < 8) || (i >= 14 && i < 19 && j >= 9 && j < 13)); });
}

}  // namespace anisoquad
