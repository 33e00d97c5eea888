#include "quad_mesh.h"

#include <gtest/gtest.h>

#include "prepare/strip_cylinder.h"
#include "quad_mesh_checks.h"
#include "wing_file.h"

namespace anisoquad {
namespace {

using stages::path;
using stages::ring;
using stages::source;

// ---------------------------------------------------------------- with sources

/// Rows of the source in the result, on both sides together.
int rows_of(const QuadMeshResult& result, std::int32_t of) {
    int rows = 0;
    for (const PassReport& pass : result.report.passes) rows += pass.source == of ? pass.rows : 0;
    return rows;
}

void expect_good_with(const shapes::Shape& shape, const std::vector<Source>& sources, double tolerance = 1e-9) {
    const QuadMeshResult result = meshed(shape, sources);
    expect_good(shape, result, sources, tolerance);
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const auto index = static_cast<std::int32_t>(s);
        EXPECT_GT(rows_of(result, index), 0);
        EXPECT_NE(std::find(result.source.begin(), result.source.end(), index), result.source.end());
    }
}

TEST(QuadMeshWithSources, OpenAcrossThePlane) {
    expect_good_with(shapes::grid(40, 30), {source(path(15 * 41, 15 * 41 + 40, 1), {{4, 0}, {2, 0}})});
}

TEST(QuadMeshWithSources, OpenInside) {
    expect_good_with(shapes::grid(44, 36), {source(path(18 * 45 + 10, 18 * 45 + 34, 1), {{3, 0}, {2, 0}})});
}

TEST(QuadMeshWithSources, OnTheBoundary) { expect_good_with(shapes::grid(40, 24), {source(path(0, 40, 1), {{4, 0}, {2, 0}})}); }

TEST(QuadMeshWithSources, FromAHoleToTheBoundary) {
    const shapes::Shape shape =
        shapes::grid_with_holes(40, 30, [](int i, int j) { return i < 10 || i >= 14 || j < 12 || j >= 18; });
    expect_good_with(shape, {source(path(15 * 41 + 14, 15 * 41 + 40, 1), {{3, 0}})});
}

TEST(QuadMeshWithSources, Several) {
    expect_good_with(shapes::grid(40, 50), {source(path(15 * 41, 15 * 41 + 40, 1), {{4, 0}}),
                                            source(path(35 * 41, 35 * 41 + 40, 1), {{2, 0}, {2, 0}})});
}

TEST(QuadMeshWithSources, ClosedOnACylinder) {
    expect_good_with(shapes::cylinder(48, 30, 1.0, 4.0), {source(ring(48, 15), {{2, 0}})}, 0.01);
}

TEST(QuadMeshWithSources, AlongACylinder) {
    expect_good_with(shapes::cylinder(48, 30, 1.0, 4.0), {source(path(5, 30 * 48 + 5, 48), {{3, 0}, {2, 0}})}, 1e-3);
}

/// Two skins and the blunt edge that joins them, as thick as given; the skins' cells are unit squares. Points (i, j) have the
/// index j·(nx + 1) + i; the edge lies between j = ny and j = ny + 1.
shapes::Shape blunt_edge(int nx, int ny, double thickness) {
    shapes::Shape shape = shapes::grid(nx, 2 * ny + 1);
    for (Point& p : shape.points) {
        const bool lower = p.y() < ny + 0.5;
        p = {p.x(), lower ? ny - p.y() : p.y() - ny - 1.0, lower ? 0.0 : thickness};
    }
    return shape;
}

TEST(QuadMeshWithSources, ABluntEdgeGetsOneQuadForEachEdgeOfTheSource) {
    const shapes::Shape shape = blunt_edge(48, 24, 0.25);
    const std::vector<Source> sources{source(path(24 * 49, 24 * 49 + 48, 1), {{4, 0}})};
    const QuadMeshResult result = meshed(shape, sources);
    expect_good(shape, result, sources, 1e-9);
    int near = 0;
    int far = 0;
    for (const Point& p : result.points) {
        if (std::abs(p.y()) > 1e-9) continue;
        ++(p.z() < 0.1 ? near : far);
    }
    EXPECT_LT(near, 25);  // of 49 nodes of the source
    EXPECT_EQ(far, near);
    EXPECT_GT(result.report.scaled_jacobian.min, 0.4);
}

TEST(QuadMeshWithSources, BothEdgesOfABluntEdge) {
    const auto edge = [](int j) { return source(path(j * 49, j * 49 + 48, 1), {{4, 0}}); };
    expect_good_with(blunt_edge(48, 24, 0.25), {edge(24), edge(25)});
}

TEST(QuadMeshWithSources, ColumnsAreNoWiderThanTheSurfaceAheadAllows) {
    // Squares as wide as the columns follow the rows, round the cylinder: at 1:8 they would leave it by 3.6e-3 of its diagonal.
    const shapes::Shape cylinder = shapes::cylinder(60, 120, 1.0, 12.0);
    const QuadMeshResult result = meshed(cylinder, {source(path(0, 120 * 60, 60), {{4, 0}, {2, 0}})});
    EXPECT_LT(result.report.hausdorff_relative, 1.5e-3);
    EXPECT_LT(result.quads.size(), 5000u) << "merged all the same";
}

TEST(QuadMeshWithSources, OnASphere) {
    expect_good_with(shapes::sphere(48, 32), {source(path(15 * 48 + 2, 15 * 48 + 30, 1), {{2, 0}})}, 0.01);
    expect_good_with(shapes::sphere(48, 32), {source(ring(48, 15), {{2, 0}})}, 0.01);
}

TEST(QuadMeshWithSources, RoundATorus) { expect_good_with(shapes::torus(60, 28), {source(ring(60, 0), {{2, 0}})}, 0.01); }

TEST(QuadMeshWithSources, OnAnEdgeOfACube) {
    const int n = 16;
    const shapes::Shape shape = shapes::cube(n);
    std::vector<std::int32_t> edge;
    for (int i = 0; i <= n; ++i) {
        const auto p = std::find(shape.points.begin(), shape.points.end(), Point(i, 0, 0));
        edge.push_back(static_cast<std::int32_t>(p - shape.points.begin()));
    }
    expect_good_with(shape, {source(edge, {{3, 0}})});
}

TEST(QuadMeshWithSources, AlongTheNoseOfALoftAtEverySize) {
    const Surface nose = strip_nose();
    for (const double size : {0.01, 0.015, 0.02, 0.03, 0.045}) {
        for (const int anisotropy : {4, 16}) {
            Options options;
            options.size = size;
            const std::vector<Source> sources{source({0, 1}, passes_for_anisotropy(anisotropy))};
            const QuadMeshResult result = quad_mesh(nose.points, nose.triangles, sources, options);
            EXPECT_EQ(result.report.inverted, 0) << size;
            EXPECT_EQ(result.report.triangles_left, 0) << size;
            ASSERT_GE(result.report.passes.size(), 2U);
            for (const PassReport& pass : result.report.passes) {
                if (pass.pass > 1) continue;
                EXPECT_GE(pass.rows, 1) << size << ", 1:" << anisotropy << ", " << pass.side << ": " << pass.stopped;
            }
            // Columns start about as wide as the rows are high, so that merged they are as long as was asked for.
            ASSERT_FALSE(result.report.rows.empty());
            EXPECT_GT(result.report.rows[0].aspect_mean, 0.6 * anisotropy) << size;
            EXPECT_LT(result.report.rows[0].aspect_mean, 2.5 * anisotropy) << size;
        }
    }
}

TEST(QuadMeshWithSources, OneSideOnly) {
    const std::vector<Source> sources{source(path(15 * 41, 15 * 41 + 40, 1), {{4, 0}}, Sides::left)};
    const shapes::Shape shape = shapes::grid(40, 30);
    const QuadMeshResult result = meshed(shape, sources);
    expect_good(shape, result, sources);
    for (std::size_t q = 0; q < result.quads.size(); ++q) {
        if (result.row[q] == 0) continue;
        for (const std::int32_t v : result.quads[q]) EXPECT_GE(result.points[static_cast<std::size_t>(v)].y(), 15.0 - 1e-9);
    }
}

TEST(QuadMeshWithSources, WithoutPassesTheyAreLinesOnly) {
    const std::vector<Source> sources{source(path(6 * 13, 6 * 13 + 12, 1), {})};
    const shapes::Shape shape = shapes::grid(12, 12);
    const QuadMeshResult result = meshed(shape, sources);
    expect_good(shape, result, sources);
    EXPECT_TRUE(result.report.passes.empty());
    EXPECT_EQ(std::count(result.row.begin(), result.row.end(), 0), static_cast<std::ptrdiff_t>(result.quads.size()));
}

// ---------------------------------------------------------------- the wing

struct Wing {
    shapes::Shape shape;
    std::vector<std::int32_t> leading_edge;
};

Wing read_wing(const std::string& name) {
    WingFile file = read_wing_file(std::string(ANISOQUAD_TEST_DATA "/") + name);
    Wing wing;
    wing.shape.points = std::move(file.points);
    wing.shape.triangles = std::move(file.triangles);
    wing.leading_edge = std::move(file.leading_edge);
    return wing;
}

TEST(QuadMeshOfTheWing, PassesFourTwoTwo) {
    const Wing wing = read_wing("wing_delta");
    ASSERT_GT(wing.leading_edge.size(), 50u);
    const std::vector<Source> sources{source(wing.leading_edge, {{4, 0}, {2, 0}, {2, 0}})};
    const QuadMeshResult result = meshed(wing.shape, sources);
    expect_consistent(wing.shape, result);
    EXPECT_EQ(euler_characteristic(result.quads), euler_characteristic(wing.shape.triangles));
    EXPECT_EQ(boundary_loops(result.quads), boundary_loops(wing.shape.triangles));
    expect_lines_covered(wing.shape, result, sources, 2e-3);
    EXPECT_GT(result.report.scaled_jacobian_min_elsewhere, 0.0);
    EXPECT_LE(result.report.hausdorff_relative, 5e-3);
    EXPECT_LT(result.quads.size(), 0.4 * static_cast<double>(wing.shape.triangles.size()));
    ASSERT_FALSE(result.report.rows.empty());
    for (const RowReport& row : result.report.rows) {
        EXPECT_TRUE(row.row != 1 || row.aspect_mean > 4.0);
    }
    for (const PassReport& pass : result.report.passes) {
        EXPECT_FALSE(pass.stopped.empty());
        EXPECT_TRUE(pass.pass != 1 || pass.rows > 0);
    }
}

TEST(QuadMeshOfTheWing, WithoutASource) {
    const Wing wing = read_wing("wing_delta");
    const QuadMeshResult result = meshed(wing.shape);
    expect_consistent(wing.shape, result);
    EXPECT_EQ(euler_characteristic(result.quads), euler_characteristic(wing.shape.triangles));
    const double share = static_cast<double>(result.quads.size()) / static_cast<double>(wing.shape.triangles.size());
    EXPECT_GT(share, 0.4);
    EXPECT_LT(share, 0.6);
    EXPECT_GT(result.report.scaled_jacobian.mean, 0.85);
}

}  // namespace
}  // namespace anisoquad
