#include "qmorph/edge_recovery.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

void expect_recovered(Prepared& p, int a, int b) {
    const HalfEdge h = recover_edge(p.mesh, Vertex(a), Vertex(b));
    ASSERT_TRUE(h.is_valid()) << a << " to " << b;
    EXPECT_EQ(p.mesh.from(h), Vertex(a));
    EXPECT_EQ(p.mesh.to(h), Vertex(b));
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

TEST(EdgeRecovery, AnEdgeThatExistsIsReturned) {
    Prepared p(shapes::grid(4, 4));
    const HalfEdge h = p.mesh.find_halfedge(Vertex(6), Vertex(7));
    EXPECT_EQ(recover_edge(p.mesh, Vertex(6), Vertex(7)), h);
    EXPECT_EQ(recover_edge(p.mesh, Vertex(7), Vertex(6)), M::twin(h));
}

TEST(EdgeRecovery, SwapsAloneMakeLinesThatMissAllNodes) {
    const int stride = 13;
    for (const auto& [di, dj] : {std::pair{2, 1}, {5, 3}, {7, 2}, {1, 6}, {8, 7}, {-3, 5}, {-7, -4}}) {
        Prepared p(shapes::grid(12, 12));
        const int a = (di < 0 ? 10 : 2) + stride * (dj < 0 ? 10 : 2);
        const int count = p.mesh.vertex_count();
        expect_recovered(p, a, a + di + stride * dj);
        EXPECT_EQ(p.mesh.vertex_count(), count);
        EXPECT_EQ(triangle_count(p.mesh), 288);
    }
}

TEST(EdgeRecovery, ANodeOnTheLineGivesWay) {
    for (const int steps : {2, 3, 5, 7}) {
        Prepared p(shapes::grid(10, 10));
        const int a = 2 + 11 * 3;
        expect_recovered(p, a, a + steps);
    }
}

TEST(EdgeRecovery, NodesThatAllButLieOnTheLineGiveWay) {
    for (const double off : {1e-6, 1e-3, 0.02}) {
        shapes::Shape shape = shapes::grid(12, 8);
        for (int i = 3; i < 10; ++i) shape.points[static_cast<std::size_t>(4 * 13 + i)].y() += off * std::sin(9.0 * i);
        for (const int steps : {4, 6, 8}) {
            Prepared p(shape);
            expect_recovered(p, 4 * 13 + 2, 4 * 13 + 2 + steps);
        }
    }
}

TEST(EdgeRecovery, BoundaryNodesAreJoinedThroughTheInside) {
    Prepared p(shapes::grid(6, 6));
    expect_recovered(p, 0, 2 * 7 + 5);
}

/// Nodes turned about z by a part of a cell, so that no three of them lie on a line of the unrolled surface.
shapes::Shape shaken(shapes::Shape shape, double cell) {
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const double turn = 0.25 * cell * std::sin(12.9898 * static_cast<double>(i));
        shape.points[i] = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * shape.points[i];
    }
    return shape;
}

TEST(EdgeRecovery, CurvedSurfaces) {
    for (const auto& [di, dj] : {std::pair{2, 1}, {3, 2}, {1, 3}}) {
        Prepared band(shaken(shapes::cylinder(64, 20), 0.1));
        expect_recovered(band, 2 * 64 + 4, (2 + dj) * 64 + 4 + di);
        Prepared ball(shaken(shapes::sphere(64, 40), 0.1));
        expect_recovered(ball, 18 * 64 + 4, (18 + dj) * 64 + 4 + di);
    }
}

TEST(EdgeRecovery, ALineIsNotCrossed) {
    Prepared p(shapes::grid(6, 6), {source(path(21, 27, 1))});
    EXPECT_FALSE(recover_edge(p.mesh, Vertex(2 * 7 + 2), Vertex(5 * 7 + 3)).is_valid());
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    expect_covered(p.mesh, path(21, 27, 1));
}

TEST(EdgeRecovery, AQuadIsNotCrossed) {
    Prepared p(shapes::grid(6, 6));
    const HalfEdge diagonal = p.mesh.find_halfedge(Vertex(3 * 7 + 3), Vertex(4 * 7 + 4));
    ASSERT_TRUE(diagonal.is_valid());
    dissolve_edge(p.mesh, M::edge(diagonal));
    EXPECT_FALSE(recover_edge(p.mesh, Vertex(3 * 7 + 2), Vertex(4 * 7 + 5)).is_valid());
    EXPECT_EQ(quad_count(p.mesh), 1);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

}  // namespace
}  // namespace anisoquad
