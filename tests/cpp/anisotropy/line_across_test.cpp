#include "anisotropy/line_across.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "anisotropy/merge.h"
#include "mesh/validate.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

constexpr int kNx = 8;

/// A plane whose lowest row of cells is a strip between the source and another line, with the source merged to two edges.
struct Strip : Prepared {
    explicit Strip(double width, const Point& bend = Point::Zero()) : Prepared(shape_of(width, bend), lines()) {
        std::vector<Vertex> all;
        for (std::int32_t i = 0; i <= kNx; ++i) all.emplace_back(i);
        for (const Vertex v : all) mesh.info(v).in_row = true;
        EXPECT_EQ(merge_source_nodes(mesh, all, {1, 0, 0, 0, 1, 0, 0, 0, 1}), 0);
    }
    static shapes::Shape shape_of(double width, const Point& bend) {
        shapes::Shape shape = shapes::grid(kNx, 6);
        for (std::size_t i = kNx + 1; i < shape.points.size(); ++i) shape.points[i].y() += width - 1.0;
        shape.points[kNx + 1 + 2] += bend;
        return shape;
    }
    static std::vector<Source> lines() { return {source(path(0, kNx, 1)), source(path(kNx + 1, 2 * kNx + 1, 1), {})}; }

    ThinnedLine thin() { return thin_line_across(mesh, std::vector{Vertex(0), Vertex(4), Vertex(8)}, 1e-3, length); }
    std::vector<double> length;
};

TEST(LineAcross, FollowsTheEdgesOfTheSource) {
    Strip p(0.2);
    const ThinnedLine thinned = p.thin();
    EXPECT_EQ(thinned.merged, 6);
    EXPECT_EQ(thinned.failed, 0);
    EXPECT_TRUE(validate(p.mesh).empty());
    EXPECT_TRUE(topology(p.mesh) == p.before);
    EXPECT_EQ(inverted_triangles(p), 0);
    for (const std::int32_t i : {kNx + 1, kNx + 5}) {
        const HalfEdge h = p.mesh.find_halfedge(Vertex(i), Vertex(i + 4));
        ASSERT_TRUE(h.is_valid());
        EXPECT_TRUE(p.mesh.is_constrained(SurfaceMesh::edge(h)));
        EXPECT_DOUBLE_EQ(p.length[static_cast<std::size_t>(i)], 4.0);
    }
    EXPECT_EQ(p.thin().merged, 0);
}

TEST(LineAcross, StaysWhereTheStripIsWide) {
    Strip p(3.0);
    EXPECT_EQ(p.thin().merged, 0);
    EXPECT_EQ(std::count(p.length.begin(), p.length.end(), 0.0), static_cast<std::ptrdiff_t>(p.length.size()));
}

TEST(LineAcross, StaysWhereItBends) {
    Strip p(0.2, Point(0, 0, 0.05));
    EXPECT_EQ(p.thin().merged, 3);  // of the other half
}

TEST(LineAcross, StaysWhereItIsASourceToo) {
    Strip p(0.2);
    for (std::int32_t i = kNx + 1; i <= 2 * kNx + 1; ++i) p.mesh.info(Vertex(i)).in_row = true;
    EXPECT_EQ(p.thin().merged, 0);
}

TEST(LineAcross, ANodeBehindItThatIsInTheWayIsTold) {
    Strip p(0.2);
    // Triangles behind the line turn over if its nodes move far along it.
    for (std::int32_t i = 2 * (kNx + 1); i < 3 * (kNx + 1); ++i) p.mesh.position(Vertex(i)).y() = i % 2 != 0 ? 0.25 : 0.6;
    const ThinnedLine thinned = p.thin();
    EXPECT_GT(thinned.failed, 0);
    EXPECT_EQ(thinned.merged + thinned.failed, 6);
    EXPECT_TRUE(validate(p.mesh).empty());
    EXPECT_EQ(inverted_triangles(p), 0);
}

}  // namespace
}  // namespace anisoquad
