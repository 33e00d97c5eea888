#include "qmorph/front.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/euler_operators.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;
constexpr double kPi = std::numbers::pi;

std::vector<HalfEdge> front(const SurfaceMesh& mesh) {
    std::vector<HalfEdge> all;
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        if (!mesh.is_deleted(HalfEdge(i)) && is_front(mesh, HalfEdge(i))) all.emplace_back(i);
    }
    return all;
}

/// The front is a set of closed loops: next and previous undo each other, and every edge starts where the one before ends.
void expect_loops(const SurfaceMesh& mesh) {
    for (const HalfEdge h : front(mesh)) {
        const HalfEdge n = next_front(mesh, h);
        ASSERT_TRUE(is_front(mesh, n));
        EXPECT_EQ(mesh.to(h), mesh.from(n));
        EXPECT_EQ(previous_front(mesh, n), h);
    }
}

TEST(Front, IsTheBoundaryAtFirst) {
    Prepared p(shapes::grid(4, 3));
    const auto all = front(p.mesh);
    EXPECT_EQ(all.size(), 14u);
    expect_loops(p.mesh);
    for (const HalfEdge h : all) {
        EXPECT_TRUE(p.mesh.is_boundary(M::twin(h)));
        EXPECT_EQ(loop_length(p.mesh, h, 100), 14);
        EXPECT_EQ(loop_length(p.mesh, h, 5), 6);
        EXPECT_GT(sector_normal(p.mesh, h).z(), 0.0);
    }
}

TEST(Front, AnglesAreThoseOfTheSector) {
    Prepared p(shapes::grid(4, 3));
    double turn = 0.0;
    for (const HalfEdge h : front(p.mesh)) {
        const Point& at = p.mesh.position(p.mesh.to(h));
        const bool corner = (at.x() == 0.0 || at.x() == 4.0) && (at.y() == 0.0 || at.y() == 3.0);
        EXPECT_NEAR(front_angle(p.mesh, h), corner ? kPi / 2 : kPi, 1e-12);
        turn += kPi - front_angle(p.mesh, h);
    }
    EXPECT_NEAR(turn, 2.0 * kPi, 1e-12);
}

TEST(Front, AnAngleIsBelowALimitOrNot) {
    Prepared plane(shapes::grid(4, 4), {source(path(11, 13, 1))});  // corners, straight sides, both ends of a slit
    Prepared disc(shapes::cone(16, 4, 0.3));
    for (const SurfaceMesh* mesh : {&plane.mesh, &disc.mesh}) {
        for (const HalfEdge h : front(*mesh)) {
            const double angle = front_angle(*mesh, h);
            for (const double limit : {0.3, 1.0, kPi / 2 - 0.01, kPi / 2 + 0.01, 0.75 * kPi, kPi - 0.01}) {
                EXPECT_EQ(is_front_angle_below(*mesh, h, limit), angle < limit) << angle << " " << limit;
            }
        }
    }
}

TEST(Front, AClosedSurfaceHasNone) { EXPECT_TRUE(front(Prepared(shapes::torus(20, 12)).mesh).empty()); }

TEST(Front, ALineInsideIsFrontOnBothSides) {
    Prepared p(shapes::grid(4, 4), {source(path(11, 13, 1))});
    expect_loops(p.mesh);
    const HalfEdge above = p.mesh.find_halfedge(Vertex(11), Vertex(12));
    EXPECT_TRUE(is_front(p.mesh, above));
    EXPECT_TRUE(is_front(p.mesh, M::twin(above)));
    EXPECT_EQ(loop_length(p.mesh, above, 100), 4);  // round the slit
    EXPECT_NEAR(front_angle(p.mesh, next_front(p.mesh, above)), 2.0 * kPi, 1e-12);
}

TEST(Front, AQuadMovesIt) {
    Prepared p(shapes::grid(4, 4));
    const HalfEdge diagonal = p.mesh.find_halfedge(Vertex(0), Vertex(6));
    ASSERT_TRUE(diagonal.is_valid());
    dissolve_edge(p.mesh, M::edge(diagonal));
    expect_loops(p.mesh);
    EXPECT_FALSE(is_front(p.mesh, p.mesh.find_halfedge(Vertex(0), Vertex(1))));
    EXPECT_TRUE(is_front(p.mesh, p.mesh.find_halfedge(Vertex(6), Vertex(1))));
    EXPECT_FALSE(is_front(p.mesh, p.mesh.find_halfedge(Vertex(1), Vertex(6))));
    EXPECT_NEAR(front_angle(p.mesh, p.mesh.find_halfedge(Vertex(5), Vertex(6))), 1.5 * kPi, 1e-12);
    EXPECT_EQ(loop_length(p.mesh, p.mesh.find_halfedge(Vertex(5), Vertex(6)), 100), 16);
}

TEST(Front, TellsWhereItGoesAlongACut) {
    Prepared p(shapes::grid(4, 3));
    const HalfEdge first = p.mesh.find_halfedge(Vertex(0), Vertex(1));
    const HalfEdge second = next_front(p.mesh, first);
    const HalfEdge third = next_front(p.mesh, second);
    p.mesh.info(M::edge(third)).cut = true;
    EXPECT_FALSE(front_way(p.mesh, first, second, 100).along_cut);
    EXPECT_TRUE(front_way(p.mesh, first, third, 100).along_cut);
    EXPECT_TRUE(front_way(p.mesh, third, first, 100).along_cut);
    EXPECT_FALSE(front_way(p.mesh, next_front(p.mesh, third), second, 100).along_cut);
}

TEST(Front, IsNearACutWithinSomeSizes) {
    Prepared p(shapes::grid(40, 3));
    Cuts cuts;
    const auto bottom = [&](std::int32_t i) { return p.mesh.find_halfedge(Vertex(i), Vertex(i + 1)); };
    EXPECT_FALSE(is_near_cut(p.mesh, bottom(30), cuts));
    cuts.add(0, 30.0, {Point(0.0, 0.0, 0.0), Point(40.0, 3.0, 0.0)});
    EXPECT_TRUE(is_near_cut(p.mesh, bottom(30), cuts));
    EXPECT_TRUE(is_near_cut(p.mesh, bottom(25), cuts));
    EXPECT_FALSE(is_near_cut(p.mesh, bottom(10), cuts));
    p.mesh.info(Vertex(10)).size = 5.0;  // larger quads reach further
    EXPECT_TRUE(is_near_cut(p.mesh, bottom(10), cuts));
}

TEST(Front, DistancesCountTheEdgesOfOneLoop) {
    Prepared p(shapes::grid_with_holes(5, 5, [](int i, int j) { return i != 2 || j != 2; }));
    const HalfEdge outer = p.mesh.find_halfedge(Vertex(0), Vertex(1));
    const HalfEdge hole = M::twin(p.mesh.halfedge(Vertex(14)));
    ASSERT_TRUE(is_front(p.mesh, hole));
    EXPECT_EQ(loop_length(p.mesh, hole, 100), 4);
    EXPECT_EQ(front_way(p.mesh, outer, outer, 100).edges, 1);
    EXPECT_EQ(front_way(p.mesh, outer, next_front(p.mesh, outer), 100).edges, 2);
    EXPECT_EQ(front_way(p.mesh, outer, previous_front(p.mesh, outer), 100).edges, 20);
    EXPECT_EQ(front_way(p.mesh, outer, previous_front(p.mesh, outer), 19).edges, -1);
    EXPECT_EQ(front_way(p.mesh, outer, hole, 100).edges, -1);
}

TEST(Front, ASpokeKnowsItsSector) {
    Prepared p(shapes::grid(4, 4), {source(path(10, 14, 1))});
    const auto edge = [&](int a, int b) { return p.mesh.find_halfedge(Vertex(a), Vertex(b)); };
    EXPECT_EQ(front_into(p.mesh, edge(12, 17)), edge(11, 12));
    EXPECT_EQ(front_into(p.mesh, edge(12, 7)), edge(13, 12));
    EXPECT_EQ(front_into(p.mesh, edge(2, 7)), edge(1, 2));
    EXPECT_FALSE(front_into(p.mesh, edge(7, 2)).is_valid());
}

}  // namespace
}  // namespace anisoquad
