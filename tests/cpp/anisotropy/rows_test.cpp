#include "anisotropy/rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "anisotropy/source_sides.h"
#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

/// A prepared surface and the empty stacks of its sources.
struct Rows : Prepared {
    LocalSize size;
    std::vector<RowStack> stacks;

    Rows(const shapes::Shape& of, const std::vector<Source>& sources, const Options& options = {})
        : Prepared(of, sources, options), size(shape.points, shape.triangles, reference), stacks(source_sides(mesh, sources)) {
        for (const RowStack& stack : stacks) {
            for (const Vertex v : stack.layers[0]) mesh.info(v).in_row = true;
        }
    }
    Rows(const Rows&) = delete;

    bool build(std::size_t i, const RowLimits& limits = {}) { return build_row(mesh, stacks[i], size, reference, limits); }
};

/// One quad per front edge in every row, on the nodes of the layers: no seam, no wedge, no column lost or gained.
void expect_structured(const Rows& p, const RowStack& stack) {
    ASSERT_EQ(stack.pass_of_row.size(), stack.rows());
    for (std::size_t j = 1; j < stack.layers.size(); ++j) {
        const auto& below = stack.layers[j - 1];
        const auto& above = stack.layers[j];
        ASSERT_EQ(above.size(), below.size());
        EXPECT_EQ(above.front() == above.back(), stack.closed);
        for (std::size_t i = 0; i < stack.columns(); ++i) {
            const HalfEdge h = p.mesh.find_halfedge(below[i], below[i + 1]);
            ASSERT_TRUE(h.is_valid());
            const Face f = p.mesh.face(h);
            ASSERT_TRUE(p.mesh.is_quad(f));
            EXPECT_EQ(p.mesh.to(p.mesh.next(h)), above[i + 1]);
            EXPECT_EQ(p.mesh.from(p.mesh.prev(h)), above[i]);
            EXPECT_EQ(p.mesh.info(f).row, static_cast<int>(j));
            EXPECT_EQ(p.mesh.info(f).source, stack.source);
            EXPECT_EQ(p.mesh.info(f).pass, stack.pass_of_row[j - 1]);
            EXPECT_GE(scaled_jacobian(p.mesh, f, p.reference.closest(centre(p.mesh, f)).normal), 0.25);
        }
        for (const Vertex v : above) EXPECT_TRUE(p.mesh.info(v).in_row);
    }
}

void expect_good(const Rows& p) {
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    for (const RowStack& stack : p.stacks) expect_structured(p, stack);
}

/// Mean height of row j, 1-based.
double height(const Rows& p, const RowStack& stack, std::size_t j) {
    double total = 0.0;
    for (std::size_t i = 0; i < stack.layers[j].size(); ++i) {
        total += (p.mesh.position(stack.layers[j][i]) - p.mesh.position(stack.layers[j - 1][i])).norm();
    }
    return total / static_cast<double>(stack.layers[j].size());
}

/// Rows on stack i until none can follow; the reason is told and nothing is broken then.
std::size_t build_all(Rows& p, std::size_t i, const RowLimits& limits = {}) {
    while (p.build(i, limits) && p.stacks[i].rows() < 100) {
    }
    EXPECT_FALSE(p.stacks[i].stopped.empty());
    return p.stacks[i].rows();
}

TEST(RowBuilding, OneQuadPerEdgeAtTheLocalHeight) {
    Rows p(shapes::grid(16, 12), {source(path(0, 16, 1))});
    const double local = std::sqrt(2.0 / std::sqrt(3.0));
    for (std::size_t j = 1; j <= 4; ++j) {
        ASSERT_TRUE(p.build(0)) << p.stacks[0].stopped;
        expect_good(p);
        EXPECT_EQ(quad_count(p.mesh), static_cast<int>(16 * j));
        EXPECT_NEAR(height(p, p.stacks[0], j), local, 0.15 * local);
    }
}

TEST(RowBuilding, TheEndColumnsTakeTheNodesOfTheLinesThere) {
    Rows p(shapes::grid(16, 12), {source(path(0, 16, 1))});
    for (int j = 1; j <= 3; ++j) {
        ASSERT_TRUE(p.build(0)) << p.stacks[0].stopped;
        EXPECT_EQ(p.stacks[0].top().front(), Vertex(17 * j));
        EXPECT_EQ(p.stacks[0].top().back(), Vertex(17 * j + 16));
    }
    for (const Vertex v : vertices(p.mesh)) {
        if (p.mesh.info(v).kind == NodeKind::interior) continue;
        EXPECT_EQ(p.mesh.position(v), p.shape.points[static_cast<std::size_t>(v.index())]);
    }
}

TEST(RowBuilding, ColumnsStayEvenOverUnevenTriangles) {
    shapes::Shape shape = shapes::grid(24, 16);
    for (std::size_t i = 25; i < shape.points.size(); ++i) {
        Point& q = shape.points[i];
        const auto k = static_cast<double>(i);
        if (i % 25 != 0 && i % 25 != 24) q += Point(0.25 * std::sin(78.2 * k), 0.25 * std::sin(37.7 * k), 0.0);
    }
    Rows p(shape, {source(path(0, 24, 1))});
    for (std::size_t j = 1; j <= 6; ++j) {
        ASSERT_TRUE(p.build(0)) << p.stacks[0].stopped;
        const auto& layer = p.stacks[0].layers[j];
        for (std::size_t i = 0; i + 1 < layer.size(); ++i)
            EXPECT_NEAR((p.mesh.position(layer[i + 1]) - p.mesh.position(layer[i])).norm(), 1.0, 0.15) << j;
    }
    expect_good(p);
}

TEST(RowBuilding, StopBeforeTheOtherSide) {
    Rows p(shapes::grid(16, 12), {source(path(0, 16, 1))});
    const std::size_t rows = build_all(p, 0);
    EXPECT_GE(rows, 5u);
    EXPECT_LE(rows, 11u);
    const int quads = quad_count(p.mesh);
    EXPECT_FALSE(p.build(0));
    EXPECT_EQ(quad_count(p.mesh), quads);
    expect_good(p);
}

TEST(RowBuilding, BothSidesOfASourceShareItsNodes) {
    Rows p(shapes::grid(14, 16), {source(path(8 * 15, 8 * 15 + 14, 1))});
    ASSERT_EQ(p.stacks.size(), 2u);
    for (int j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 2; ++i) ASSERT_TRUE(p.build(i)) << p.stacks[i].stopped;
    }
    expect_good(p);
    const std::size_t last = p.stacks[0].columns();
    for (std::size_t i = 0; i <= last; ++i) EXPECT_EQ(p.stacks[0].layers[0][i], p.stacks[1].layers[0][last - i]);
    for (std::size_t i = 0; i < last; ++i) {
        const HalfEdge h = p.mesh.find_halfedge(p.stacks[0].layers[0][i], p.stacks[0].layers[0][i + 1]);
        EXPECT_TRUE(p.mesh.is_quad(p.mesh.face(h)) && p.mesh.is_quad(p.mesh.face(M::twin(h))));
    }
}

TEST(RowBuilding, FreeEndsInsideAreSquareToTheSource) {
    Rows p(shapes::grid(16, 16), {source(path(8 * 17 + 4, 8 * 17 + 12, 1))});
    for (int j = 0; j < 2; ++j) {
        for (std::size_t i = 0; i < 2; ++i) ASSERT_TRUE(p.build(i)) << p.stacks[i].stopped;
    }
    expect_good(p);
    for (const RowStack& stack : p.stacks) {
        for (const std::size_t i : {std::size_t(0), stack.columns()}) {
            const Eigen::Vector3d up = p.mesh.position(stack.layers[2][i]) - p.mesh.position(stack.layers[0][i]);
            EXPECT_LT(std::abs(up.x()), 0.35 * std::abs(up.y()));
            EXPECT_GT(up.y() * (stack.left ? 1.0 : -1.0), 0.0);
        }
    }
}

TEST(RowBuilding, AClosedSourceHasNoEnds) {
    Rows p(shapes::cylinder(30, 20, 1.0, 4.0), {source(ring(30, 10))});
    for (int j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 2; ++i) ASSERT_TRUE(p.build(i)) << p.stacks[i].stopped;
    }
    expect_good(p);
    EXPECT_EQ(quad_count(p.mesh), 180);
    for (const RowStack& stack : p.stacks) {
        double low = 1e9;
        double high = 0.0;
        for (const Vertex v : stack.top()) {
            const double off = std::abs(p.mesh.position(v).z() - 2.0);
            low = std::min(low, off);
            high = std::max(high, off);
            EXPECT_NEAR(p.mesh.position(v).head<2>().norm(), 1.0, 0.01);
        }
        EXPECT_LT(high, 1.15 * low);
    }
}

TEST(RowBuilding, HeightsGrowByTheLimitAtMost) {
    shapes::Shape shape = shapes::grid(20, 14);
    double y = 0.0;
    for (int j = 0; j <= 14; ++j) {  // triangles that get higher by 1.3 from the source on
        for (int i = 0; i <= 20; ++i) shape.points[static_cast<std::size_t>(21 * j + i)].y() = y;
        y += 0.15 * std::pow(1.3, j);
    }
    // Lines at the ends would give their nodes' heights: the source ends inside.
    for (const double growth : {1.0, 1.1, 1.2}) {
        Rows p(shape, {source(path(5 * 21 + 5, 5 * 21 + 15, 1), {{2, 0}}, Sides::left)});
        RowLimits limits;
        limits.growth = growth;
        build_all(p, 0, limits);
        ASSERT_GE(p.stacks[0].rows(), 2u) << p.stacks[0].stopped;
        for (std::size_t j = 2; j <= p.stacks[0].rows(); ++j) {
            const double ratio = height(p, p.stacks[0], j) / height(p, p.stacks[0], j - 1);
            EXPECT_LT(ratio, 1.1 * growth);
            EXPECT_GT(ratio, 0.95);
        }
        expect_good(p);
    }
}

TEST(RowBuilding, TrianglesTooLargeForTheFrontStopThem) {
    Rows p(shapes::grid(16, 8, 0.2, 1.0), {source(path(0, 16, 1))});
    RowLimits limits;
    limits.longest_height = 1.6;
    EXPECT_FALSE(p.build(0, limits));
    EXPECT_FALSE(p.stacks[0].stopped.empty());
    EXPECT_EQ(quad_count(p.mesh), 0);
    expect_good(p);
}

TEST(RowBuilding, ClearanceIsKeptFree) {
    Rows near(shapes::grid(16, 12), {source(path(0, 16, 1))});
    Rows far(shapes::grid(16, 12), {source(path(0, 16, 1))});
    RowLimits wide;
    wide.clearance = 5.0;
    EXPECT_LT(build_all(far, 0, wide), build_all(near, 0));
    expect_good(far);
}

TEST(RowBuilding, TwoSourcesDoNotCollide) {
    Rows p(shapes::grid(16, 20), {source(path(5 * 17, 5 * 17 + 16, 1)), source(path(15 * 17, 15 * 17 + 16, 1))});
    ASSERT_EQ(p.stacks.size(), 4u);
    std::vector<char> active(4, 1);
    while (std::count(active.begin(), active.end(), 1) > 0) {
        for (std::size_t i = 0; i < 4; ++i) active[i] = active[i] && p.build(i);
    }
    expect_good(p);
    for (const RowStack& stack : p.stacks) {
        EXPECT_GE(stack.rows(), 2u);
        EXPECT_LE(stack.rows(), 5u);
    }
}

TEST(RowBuilding, SeveralPassesAreTold) {
    Rows p(shapes::grid(12, 10), {source(path(0, 12, 1))});
    ASSERT_TRUE(p.build(0));
    RowLimits limits;
    limits.pass = 2;
    ASSERT_TRUE(p.build(0, limits));
    EXPECT_EQ(p.stacks[0].pass_of_row, (std::vector<std::int32_t>{1, 2}));
    expect_good(p);
}

TEST(RowBuilding, FollowCurvedSurfaces) {
    Rows ball(shapes::sphere(40, 30), {source(path(15 * 40 + 3, 15 * 40 + 20, 1))});
    for (int j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 2; ++i) ASSERT_TRUE(ball.build(i)) << ball.stacks[i].stopped;
    }
    expect_good(ball);
    for (const RowStack& stack : ball.stacks) {
        for (const auto& layer : stack.layers) {
            for (const Vertex v : layer) EXPECT_NEAR(ball.mesh.position(v).norm(), 1.0, 2e-3);
        }
    }
}

}  // namespace
}  // namespace anisoquad
