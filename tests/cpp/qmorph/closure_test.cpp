#include "qmorph/closure.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/euler_operators.h"
#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

HalfEdge edge(const SurfaceMesh& mesh, int a, int b) { return mesh.find_halfedge(Vertex(a), Vertex(b)); }

/// Regular polygon of n edges with one node in its middle.
shapes::Shape wheel(int n, double squeeze = 1.0) {
    shapes::Shape shape;
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * i / n;
        shape.points.emplace_back(std::cos(a), squeeze * std::sin(a), 0.0);
    }
    shape.points.emplace_back(0.05, 0.02, 0.0);
    for (int i = 0; i < n; ++i) shape.triangles.push_back({i, (i + 1) % n, n});
    return shape;
}

void expect_quads(const Prepared& p) {
    expect_sound(p);
    EXPECT_EQ(triangle_count(p.mesh), 0);
    for (const Face f : faces(p.mesh)) EXPECT_TRUE(p.mesh.is_quad(f));
}

TEST(Closure, FourEdgesAreOneQuad) {
    for (const auto& shape : {shapes::grid(1, 1), wheel(4)}) {
        Prepared p(shape);
        const double area = input_area(shape);
        ASSERT_TRUE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 4));
        expect_quads(p);
        EXPECT_EQ(p.mesh.face_count(), 1);
        EXPECT_NEAR(signed_area(p), area, 1e-12);
    }
}

TEST(Closure, SixEdgesAreTwoOrThreeQuads) {
    for (const auto& shape : {shapes::grid(2, 1), wheel(6), wheel(6, 0.5), wheel(6, 2.0)}) {
        Prepared p(shape);
        const double area = input_area(shape);
        const HalfEdge h = edge(p.mesh, 0, 1);
        ASSERT_EQ(loop_length(p.mesh, h, 10), 6);
        ASSERT_TRUE(close_small_loop(p.mesh, h, 6));
        expect_quads(p);
        EXPECT_LE(p.mesh.face_count(), 3);
        EXPECT_NEAR(signed_area(p), area, 1e-12);
        for (const Face f : faces(p.mesh)) EXPECT_GT(scaled_jacobian(p.mesh, f), 0.3);
    }
}

TEST(Closure, TheTemplateFitsTheCorners) {
    // Alternating corners of 60° and 180°: no diagonal makes two good quads, three spokes from the middle do.
    shapes::Shape shape = wheel(6);
    for (std::size_t i = 1; i < 6; i += 2) shape.points[i] = 0.5 * (shape.points[i - 1] + shape.points[(i + 1) % 6]);
    Prepared p(shape);
    ASSERT_TRUE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 6));
    expect_quads(p);
    EXPECT_EQ(p.mesh.face_count(), 3);
    for (const Face f : faces(p.mesh)) EXPECT_NEAR(scaled_jacobian(p.mesh, f), std::sin(std::numbers::pi / 3), 1e-9);
}

TEST(Closure, AnotherLengthIsNotClosed) {
    Prepared p(wheel(8));
    EXPECT_FALSE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 8));
    EXPECT_EQ(triangle_count(p.mesh), 8);
}

TEST(Closure, WhatIsNoDiskOfTrianglesStays) {
    // A square with a square hole.
    shapes::Shape shape;
    shape.points = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    for (int i = 0; i < 4; ++i) shape.add_quad(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i);
    Prepared p(shape);
    EXPECT_FALSE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 4));
    EXPECT_FALSE(close_small_loop(p.mesh, edge(p.mesh, 5, 4), 4));
    EXPECT_EQ(triangle_count(p.mesh), 8);
    expect_sound(p);
}

TEST(Closure, AFoldedQuadIsNotMade) {
    shapes::Shape shape;
    shape.points = {{0, 1, 0}, {-1, -1, 0}, {0, 0.5, 0}, {1, -1, 0}};
    shape.triangles = {{0, 1, 2}, {0, 2, 3}};
    Prepared p(shape);
    EXPECT_FALSE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 4));
    EXPECT_EQ(triangle_count(p.mesh), 2);
}

/// Four quads round a dart of two triangles.
Prepared dart() {
    shapes::Shape shape;
    shape.points = {{0, 1, 0}, {-1, -1, 0}, {0, 0.5, 0}, {1, -1, 0}, {0, 3, 0}, {-3, -3, 0}, {0, -1, 0}, {3, -3, 0}};
    shape.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}, {5, 6, 1},
                       {6, 2, 1}, {6, 7, 3}, {6, 3, 2}, {7, 4, 0}, {7, 0, 3}};
    Prepared p(shape);
    for (const auto& [a, b] : {std::array{4, 1}, {6, 1}, {6, 3}, {7, 0}}) dissolve_edge(p.mesh, M::edge(edge(p.mesh, a, b)));
    return p;
}

TEST(Closure, WhereTheFrontSpiralsAFoldedQuadIsMade) {
    Prepared p = dart();
    EXPECT_FALSE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 4));
    EXPECT_TRUE(close_small_loop(p.mesh, edge(p.mesh, 0, 1), 4, true));
    EXPECT_EQ(triangle_count(p.mesh), 0);
    expect_sound(p);
}

TEST(Closure, NoFoldedQuadIsMadeThatSmoothingCanNotOpen) {
    Prepared bent = dart();
    bent.mesh.position(Vertex(2)).z() = 2.0;
    EXPECT_FALSE(close_small_loop(bent.mesh, edge(bent.mesh, 0, 1), 4, true));
    Prepared held = dart();
    held.mesh.info(Vertex(2)).kind = NodeKind::line;
    EXPECT_FALSE(close_small_loop(held.mesh, edge(held.mesh, 0, 1), 4, true));
}

TEST(FinishRemaining, NeighboursArePairedBestFirst) {
    Prepared p(shapes::grid(5, 4));
    const FinishResult result = finish_remaining(p.mesh);
    EXPECT_EQ(result.pairs, 20);
    EXPECT_EQ(result.walks, 0);
    EXPECT_EQ(result.left, 0);
    expect_quads(p);
    for (const Face f : faces(p.mesh)) EXPECT_NEAR(scaled_jacobian(p.mesh, f), 1.0, 1e-12);
}

/// A triangle at each end of a strip of n quads.
Prepared strip(int n) {
    shapes::Shape shape = shapes::grid(n, 1);
    const auto left = static_cast<std::int32_t>(shape.points.size());
    shape.points.emplace_back(-1.0, 0.5, 0.0);
    shape.points.emplace_back(n + 1.0, 0.5, 0.0);
    shape.triangles.insert(shape.triangles.end(), {{0, n + 1, left}, {n, left + 1, 2 * n + 1}});
    Prepared p(shape);
    for (int i = 0; i < n; ++i) {
        HalfEdge h = edge(p.mesh, i, n + 2 + i);
        if (!h.is_valid()) h = edge(p.mesh, i + 1, n + 1 + i);
        dissolve_edge(p.mesh, M::edge(h));
    }
    return p;
}

TEST(FinishRemaining, SingleTrianglesWalkTowardsEachOther) {
    for (const int n : {1, 2, 3, 7, 20}) {
        Prepared p = strip(n);
        ASSERT_EQ(triangle_count(p.mesh), 2);
        const int nodes = p.mesh.vertex_count();
        const FinishResult result = finish_remaining(p.mesh);
        EXPECT_EQ(result.pairs, 0);
        EXPECT_EQ(result.walks, 1);
        EXPECT_EQ(result.left, 0);
        EXPECT_EQ(p.mesh.vertex_count(), nodes);
        EXPECT_EQ(p.mesh.face_count(), n + 1);
        EXPECT_NEAR(signed_area(p), n + 1.0, 1e-9);
        expect_quads(p);
    }
}

TEST(FinishRemaining, RowsAndLinesAreNotCrossed) {
    Prepared row = strip(5);
    row.mesh.info(row.mesh.face(edge(row.mesh, 2, 3))).row = 1;
    EXPECT_EQ(finish_remaining(row.mesh).left, 2);
    expect_sound(row);
    Prepared line = strip(5);
    line.mesh.info(M::edge(edge(line.mesh, 2, 8))).line = 9;
    EXPECT_EQ(finish_remaining(line.mesh).left, 2);
    EXPECT_EQ(line.mesh.info(M::edge(edge(line.mesh, 2, 8))).line, 9);
    expect_sound(line);
}

/// The triangle 0 1 3 and the quad 3 1 2 0 behind it: the line from 1 ends at 3, between them.
Prepared with_a_line_that_ends(const shapes::Shape& shape) {
    Prepared p(shape);
    dissolve_edge(p.mesh, M::edge(edge(p.mesh, 3, 2)));
    p.mesh.info(M::edge(edge(p.mesh, 1, 3))).line = 9;
    p.mesh.info(Vertex(3)).kind = NodeKind::corner;
    return p;
}

void expect_quads_and_the_line(const Prepared& p) {
    ASSERT_TRUE(edge(p.mesh, 1, 3).is_valid());
    EXPECT_EQ(p.mesh.info(M::edge(edge(p.mesh, 1, 3))).line, 9);
    expect_quads(p);
}

/// The only way leads round the end of a line that juts into a triangle's outline: the pentagon there holds a node twice.
TEST(FinishRemaining, ATriangleWalksRoundTheEndOfALine) {
    shapes::Shape shape;
    shape.points = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, 2.0, 0.0}, {1.0, 0.7, 0.0}, {-1.0, 1.5, 0.0}};
    shape.triangles = {{0, 1, 3}, {3, 1, 2}, {3, 2, 0}, {0, 2, 4}};
    Prepared p = with_a_line_that_ends(shape);
    const FinishResult result = finish_remaining(p.mesh);
    EXPECT_EQ(result.walks, 1);
    EXPECT_EQ(result.left, 0);
    EXPECT_EQ(p.mesh.face_count(), 3);
    EXPECT_EQ(p.mesh.vertex_count(), 6);
    expect_quads_and_the_line(p);
}

/// There the triangle cannot come out at the side of the line: it stays a triangle, and the other one comes to it.
TEST(FinishRemaining, AWayThatIsNoneIsGivenUp) {
    shapes::Shape shape;
    shape.points = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, 2.0, 0.0}, {1.0, 0.7, 0.0},
                    {3.0, 0.5, 0.0}, {2.0, 2.5, 0.0}, {4.0, 2.0, 0.0}};
    shape.triangles = {{0, 1, 3}, {3, 1, 2}, {3, 2, 0}, {1, 4, 2}, {4, 5, 2}, {4, 6, 5}};
    Prepared p = with_a_line_that_ends(shape);
    dissolve_edge(p.mesh, M::edge(edge(p.mesh, 4, 2)));
    const FinishResult result = finish_remaining(p.mesh);
    EXPECT_EQ(result.walks, 1);
    EXPECT_EQ(result.left, 0);
    EXPECT_EQ(p.mesh.face_count(), 3);
    expect_quads_and_the_line(p);
}

TEST(FinishRemaining, AnySurfaceOfEvenlyManyTrianglesEndsAllQuads) {
    for (const auto& shape :
         {shapes::sphere(13, 9), shapes::torus(15, 8), shapes::cylinder(11, 7), shapes::grid(7, 9, 1.0, 0.3)}) {
        Prepared p(shape);
        EXPECT_EQ(finish_remaining(p.mesh).left, 0);
        expect_quads(p);
        EXPECT_EQ(static_cast<std::size_t>(p.mesh.face_count()), shape.triangles.size() / 2);
    }
}

TEST(FinishRemaining, AnOddTriangleIsCounted) {
    shapes::Shape shape = shapes::grid(4, 4);
    shape.triangles.pop_back();
    Prepared p(shape);
    EXPECT_EQ(finish_remaining(p.mesh).left, 1);
    expect_sound(p);
}

}  // namespace
}  // namespace anisoquad
