#include "cad/edge_paths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cad/triangulate.h"
#include "cad_shapes.h"

namespace anisoquad::cad {
namespace {

/// Every path runs over mesh edges along its curve; its ends are the edge's vertices.
void expect_paths(const CadShape& shape, const Triangulation& mesh, double noise = 0.0) {
    std::vector<Eigen::Vector3d> points = mesh.points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += noise * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i % 3));
    const EdgePaths found = find_edge_paths(shape, points, mesh.triangles, 0.02);
    const Neighbours neighbours(points.size(), mesh.triangles);
    for (std::size_t e = 0; e < shape.edges().size(); ++e) {
        const CadEdge& edge = shape.edges()[e];
        const EdgePath& path = found.paths[e];
        if (edge.is_degenerated()) {
            EXPECT_TRUE(path.vertices.empty());
            continue;
        }
        ASSERT_GE(path.vertices.size(), 2u) << shape.name() << " edge " << e;
        EXPECT_EQ(path.vertices.front() == path.vertices.back(), edge.range.closed);
        EXPECT_TRUE(std::is_sorted(path.parameters.begin(), path.parameters.end()));
        double length = 0.0;
        for (std::size_t i = 0; i < path.vertices.size(); ++i) {
            const Eigen::Vector3d& p = points[static_cast<std::size_t>(path.vertices[i])];
            const gp_Pnt on = edge.curve->Value(path.parameters[i]);
            EXPECT_LT((p - Eigen::Vector3d(on.X(), on.Y(), on.Z())).norm(), 2.0 * noise + 1e-9);
            if (i == 0) continue;
            length += (p - points[static_cast<std::size_t>(path.vertices[i - 1])]).norm();
            const auto of = neighbours.of(path.vertices[i - 1]);
            EXPECT_TRUE(std::binary_search(of.begin(), of.end(), path.vertices[i]));
        }
        EXPECT_NEAR(length, edge.length, 0.02 * edge.length) << shape.name() << " edge " << e;
    }
}

TEST(EdgePaths, FollowTheEdgesOfTessellations) {
    for (const CadShape& shape : {shapes::box(), shapes::cylinder(), shapes::sphere(), shapes::cone(), shapes::torus(),
                                  shapes::stadium(), shapes::wavy()}) {
        expect_paths(shape, triangulate(shape));
    }
}

TEST(EdgePaths, BearPointsOfSinglePrecision) {
    const CadShape stadium = shapes::stadium();
    expect_paths(stadium, triangulate(stadium), 2e-7);
}

TEST(EdgePaths, PassVerticesThatAreAlmostOnTheCurveButLeadNowhere) {
    // As beside a sharp nose: a vertex nearer to an edge than single precision tells, from which the edge does not go on.
    const CadShape box = shapes::box();
    Triangulation mesh = triangulate(box);
    const auto edge = static_cast<std::size_t>(shapes::edge_of_length(box, 3.0));
    const std::vector<std::int32_t> ends = find_edge_paths(box, mesh.points, mesh.triangles, 0.02).paths[edge].vertices;
    ASSERT_EQ(ends.size(), 2u);
    const auto at = [&](std::int32_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
    const auto beside = static_cast<std::int32_t>(mesh.points.size());
    const std::int32_t inside = beside + 1;
    for (std::size_t f = 0; f < mesh.triangles.size() && mesh.points.size() == static_cast<std::size_t>(beside); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = mesh.triangles[f][k];
            const std::int32_t b = mesh.triangles[f][(k + 1) % 3];
            const std::int32_t c = mesh.triangles[f][(k + 2) % 3];
            if (std::min(a, b) != std::min(ends[0], ends[1]) || std::max(a, b) != std::max(ends[0], ends[1])) continue;
            const Eigen::Vector3d along = at(ends[1]) - at(ends[0]);
            mesh.points.push_back(at(ends[0]) + 0.3 * along + 1e-6 * (at(c) - at(a)));
            mesh.points.push_back((at(a) + at(b) + at(c)) / 3.0);
            mesh.triangles[f] = {a, b, inside};
            mesh.triangles.push_back({b, c, inside});
            mesh.triangles.push_back({ends[0], inside, beside});
            mesh.triangles.push_back({inside, c, beside});
            mesh.triangles.push_back({c, ends[0], beside});
            break;
        }
    }
    ASSERT_EQ(mesh.points.size(), static_cast<std::size_t>(beside) + 2);
    EXPECT_EQ(find_edge_paths(box, mesh.points, mesh.triangles, 0.02).paths[edge].vertices, ends);
}

TEST(EdgePaths, AreEmptyWhereTheMeshDoesNotFollow) {
    const CadShape box = shapes::box();
    const Triangulation other = triangulate(shapes::cylinder());
    for (const EdgePath& path : find_edge_paths(box, other.points, other.triangles, 0.02).paths)
        EXPECT_TRUE(path.vertices.empty());
}

}  // namespace
}  // namespace anisoquad::cad
