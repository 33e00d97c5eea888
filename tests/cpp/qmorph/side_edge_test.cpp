#include "qmorph/side_edge.h"

#include <gtest/gtest.h>

#include <numbers>

#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;
constexpr double kPi = std::numbers::pi;

HalfEdge edge(const SurfaceMesh& mesh, int a, int b) { return mesh.find_halfedge(Vertex(a), Vertex(b)); }

TEST(SideEdge, AtASharpTurnItIsTheNeighbouringFrontEdge) {
    Prepared p(shapes::grid(4, 4));
    EXPECT_EQ(choose_side_edge(p.mesh, edge(p.mesh, 3, 4), End::right, Vertex()), edge(p.mesh, 4, 9));
    EXPECT_EQ(choose_side_edge(p.mesh, edge(p.mesh, 0, 1), End::left, Vertex()), edge(p.mesh, 0, 5));
}

TEST(SideEdge, AnEdgeCloseToTheBisectorIsTakenAsItIs) {
    Prepared p(shapes::grid(4, 4));
    for (const End end : {End::left, End::right}) {
        const HalfEdge side = choose_side_edge(p.mesh, edge(p.mesh, 1, 2), end, Vertex());
        EXPECT_EQ(side, end == End::left ? edge(p.mesh, 1, 6) : edge(p.mesh, 2, 7));
    }
    EXPECT_EQ(p.mesh.vertex_count(), 25);
    EXPECT_EQ(triangle_count(p.mesh), 32);
}

TEST(SideEdge, TheNodeToAvoidIsAvoided) {
    Prepared p(shapes::grid(4, 4));
    const HalfEdge side = choose_side_edge(p.mesh, edge(p.mesh, 1, 2), End::right, Vertex(7));
    ASSERT_TRUE(side.is_valid());
    EXPECT_EQ(p.mesh.from(side), Vertex(2));
    EXPECT_NE(p.mesh.to(side), Vertex(7));
    expect_sound(p);
}

/// A front along y = 0 whose node 1 has edges at 45° and 135° only; beyond them lies an apex at the given height.
shapes::Shape gap(double reach, double apex) {
    shapes::Shape shape;
    shape.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {reach, reach, 0}, {0, apex, 0}, {-reach, reach, 0}};
    shape.triangles = {{1, 2, 3}, {1, 3, 5}, {1, 5, 0}, {5, 3, 4}};
    return shape;
}

TEST(SideEdge, TheEdgeThatTheBisectorCrossesIsSwapped) {
    Prepared p(gap(1.0, 1.2));
    const HalfEdge side = choose_side_edge(p.mesh, edge(p.mesh, 0, 1), End::right, Vertex());
    ASSERT_TRUE(side.is_valid());
    EXPECT_EQ(p.mesh.from(side), Vertex(1));
    EXPECT_EQ(p.mesh.to(side), Vertex(4));
    EXPECT_EQ(p.mesh.vertex_count(), 6);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

TEST(SideEdge, OrSplitWhereTheBisectorMeetsItIfTheApexIsTooFar) {
    Prepared p(gap(1.0, 5.0));
    const HalfEdge side = choose_side_edge(p.mesh, edge(p.mesh, 0, 1), End::right, Vertex());
    ASSERT_TRUE(side.is_valid());
    EXPECT_EQ(p.mesh.from(side), Vertex(1));
    EXPECT_TRUE(p.mesh.position(p.mesh.to(side)).isApprox(Point(0, 1, 0)));
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

TEST(SideEdge, AnEdgeFarAwayIsSplitAndTheNewEdgeCutToTheFrontsLength) {
    Prepared p(gap(3.0, 20.0));
    const HalfEdge side = choose_side_edge(p.mesh, edge(p.mesh, 1, 2), End::left, Vertex());
    ASSERT_TRUE(side.is_valid());
    EXPECT_EQ(p.mesh.from(side), Vertex(1));
    EXPECT_TRUE(p.mesh.position(p.mesh.to(side)).isApprox(Point(0, 1, 0)));
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
}

TEST(SideEdge, AnEdgeFarShorterThanWantedIsNotSplit) {
    for (const double size : {5.0, 500.0}) {
        Prepared p(gap(1.0, 5.0));
        for (std::int32_t i = 0; i < p.mesh.vertex_slots(); ++i) p.mesh.info(Vertex(i)).size = size;
        EXPECT_EQ(choose_side_edge(p.mesh, edge(p.mesh, 0, 1), End::right, Vertex()).is_valid(), size < 100.0);
        expect_sound(p);
    }
}

TEST(SideEdge, TwoOddLoopsAreNotMade) {
    // Four front edges on each side of 1 – 5: closing there would leave two loops of five.
    shapes::Shape shape;
    shape.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {-0.5, 1, 0}, {-1, 1, 0}};
    shape.triangles = {{0, 1, 7}, {1, 6, 7}, {1, 5, 6}, {1, 2, 5}, {2, 3, 4}, {2, 4, 5}};
    for (const End end : {End::left, End::right}) {
        Prepared p(shape);
        const HalfEdge front = end == End::right ? edge(p.mesh, 0, 1) : edge(p.mesh, 1, 2);
        const HalfEdge side = choose_side_edge(p.mesh, front, end, Vertex());
        ASSERT_TRUE(side.is_valid());
        EXPECT_FALSE(front_into(p.mesh, M::twin(side)).is_valid()) << "ends on the front";
        expect_sound(p);
        EXPECT_EQ(inverted_triangles(p), 0);
    }
}

TEST(SideEdge, AtAReentrantCornerItIsSquareToTheFrontEdge) {
    Prepared p(shapes::grid_with_holes(6, 6, [](int i, int j) { return i < 3 || j >= 3; }));
    const int corner = 3 * 7 + 3;
    // The front runs up the wall x = 3 to the corner's node, then on along y = 3.
    for (const End end : {End::right, End::left}) {
        const HalfEdge front = end == End::right ? edge(p.mesh, corner - 7, corner) : edge(p.mesh, corner, corner + 1);
        ASSERT_TRUE(is_front(p.mesh, front));
        const HalfEdge side = choose_side_edge(p.mesh, front, end, Vertex());
        ASSERT_TRUE(side.is_valid());
        const Eigen::Vector3d a = p.mesh.position(p.mesh.to(front)) - p.mesh.position(p.mesh.from(front));
        const Eigen::Vector3d b = p.mesh.position(p.mesh.to(side)) - p.mesh.position(p.mesh.from(side));
        EXPECT_GE(a.cross(b).z(), a.norm() * b.norm() * std::cos(kPi / 6));
    }
}

}  // namespace
}  // namespace anisoquad
