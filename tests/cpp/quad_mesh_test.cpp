#include "quad_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "quality/metrics.h"
#include "stages.h"
#include "wing_file.h"

namespace anisoquad {
namespace {

using stages::path;
using stages::ring;
using stages::source;
using Pair = std::pair<std::int32_t, std::int32_t>;

QuadMeshResult meshed(const shapes::Shape& shape, const std::vector<Source>& sources = {}, const Options& options = {}) {
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

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const double t = std::clamp((b - a).dot(p - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (a + t * (b - a) - p).norm();
}

double diagonal(const shapes::Shape& shape) {
    Point low = shape.points[0];
    Point high = shape.points[0];
    for (const Point& p : shape.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (high - low).norm();
}

/// All arrays agree with each other, and with the input where they say so.
void expect_consistent(const shapes::Shape& shape, const QuadMeshResult& result) {
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
void expect_oriented(const shapes::Shape& shape, const QuadMeshResult& result) {
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
void expect_lines_covered(const shapes::Shape& shape, const QuadMeshResult& result, const std::vector<Source>& sources,
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

void expect_good(const shapes::Shape& shape, const QuadMeshResult& result, const std::vector<Source>& sources = {},
                 double tolerance = 1e-9) {
    expect_consistent(shape, result);
    if (testing::Test::HasFatalFailure()) return;
    EXPECT_EQ(euler_characteristic(result.quads), euler_characteristic(shape.triangles));
    EXPECT_EQ(boundary_loops(result.quads), boundary_loops(shape.triangles));
    expect_oriented(shape, result);
    expect_lines_covered(shape, result, sources, tolerance);
}

shapes::Shape plane_with_holes() {
    return shapes::grid_with_holes(
        24, 18, [](int i, int j) { return !((i >= 4 && i < 8 && j >= 4 && j < 8) || (i >= 14 && i < 19 && j >= 9 && j < 13)); });
}

// ---------------------------------------------------------------- without a source

TEST(QuadMesh, PlaneWithHoles) {
    for (const auto& shape : {shapes::grid(12, 9), plane_with_holes()}) {
        const QuadMeshResult result = meshed(shape);
        expect_good(shape, result);
        EXPECT_GT(result.report.scaled_jacobian.min, 0.25);
        EXPECT_LT(result.report.hausdorff_relative, 1e-9);
        EXPECT_LT(result.quads.size(), 0.8 * static_cast<double>(shape.triangles.size()));
    }
}

TEST(QuadMesh, Cylinder) {
    const shapes::Shape shape = shapes::cylinder(36, 18, 1.0, 3.0);
    const QuadMeshResult result = meshed(shape);
    expect_good(shape, result);
    EXPECT_LT(result.report.hausdorff_relative, 0.01);
}

TEST(QuadMesh, Sphere) {
    const shapes::Shape shape = shapes::sphere(36, 22);
    const QuadMeshResult result = meshed(shape);
    expect_good(shape, result);
    EXPECT_TRUE(result.line_edges.empty());
    EXPECT_LT(result.report.hausdorff_relative, 0.02);
}

TEST(QuadMesh, Torus) {
    const shapes::Shape shape = shapes::torus(48, 24);
    const QuadMeshResult result = meshed(shape);
    expect_good(shape, result);
    EXPECT_LT(result.report.hausdorff_relative, 0.02);
}

TEST(QuadMesh, Cube) {
    const shapes::Shape shape = shapes::cube(6);
    const QuadMeshResult result = meshed(shape);
    expect_good(shape, result);
    EXPECT_EQ(result.report.patches, 6);
    EXPECT_EQ(result.report.feature_lines, 12);
    EXPECT_LT(result.report.hausdorff_relative, 1e-9);
}

TEST(QuadMesh, SmallAndOddSurfaces) {
    shapes::Shape odd = shapes::grid(7, 5);
    odd.triangles.erase(odd.triangles.begin());
    for (const auto& shape : {shapes::grid(1, 1), shapes::grid(2, 2), shapes::grid(5, 1), odd, shapes::cube(1)})
        expect_good(shape, meshed(shape));
}

TEST(QuadMesh, SeveralComponents) {
    const shapes::Shape shape = shapes::joined(shapes::sphere(24, 16), shapes::placed(plane_with_holes(), 0.1, Point(3, 0, 0)));
    const QuadMeshResult result = meshed(shape);
    expect_good(shape, result);
    EXPECT_EQ(result.report.components, 2);
}

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

// ---------------------------------------------------------------- what holds for every run

/// A plane whose nodes are shaken by a fixed rule, so that no choice is a tie.
shapes::Shape shaken(int nx, int ny) {
    shapes::Shape shape = shapes::grid(nx, ny);
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        Point& p = shape.points[i];
        const bool side = p.x() == 0.0 || p.x() == nx;
        const bool line = p.y() == 0.0 || p.y() == ny || p.y() == ny / 2;
        if (!side) p.x() += 0.2 * std::sin(12.9898 * static_cast<double>(i));
        if (!line) p.y() += 0.2 * std::sin(78.233 * static_cast<double>(i));
    }
    return shape;
}

TEST(QuadMesh, UnitAndPlaceDoNotMatter) {
    for (const auto& sources : {std::vector<Source>{}, std::vector<Source>{source(path(12 * 31, 12 * 31 + 30, 1), {{3, 0}})}}) {
        const shapes::Shape shape = shaken(30, 24);
        const QuadMeshResult result = meshed(shape, sources);
        for (const auto& [scale, offset] :
             {std::pair{1e-6, Point(0, 0, 0)}, {1.0, Point(1e3, -1e3, 1e3)}, {1e-6, Point(1e-3, 0, 1e-3)}}) {
            const QuadMeshResult other = meshed(shapes::placed(shape, scale, offset), sources);
            SCOPED_TRACE(testing::Message() << sources.size() << " sources, scale " << scale << ", offset "
                                            << offset.transpose());
            EXPECT_EQ(other.quads.size(), result.quads.size());
            EXPECT_EQ(other.points.size(), result.points.size());
            EXPECT_EQ(other.line_edges.size(), result.line_edges.size());
            EXPECT_TRUE(other.quads == result.quads);
            for (std::size_t i = 0; i < std::min(result.points.size(), other.points.size()); ++i) {
                EXPECT_LT((other.points[i] - (scale * result.points[i] + offset)).norm(), 1e-4 * scale);
            }
        }
    }
}

TEST(QuadMesh, TheSameInputGivesTheSameBytes) {
    const shapes::Shape shape = shapes::sphere(40, 26);
    const std::vector<Source> sources{source(path(12 * 40 + 2, 12 * 40 + 26, 1), {{3, 0}})};
    const QuadMeshResult a = meshed(shape, sources);
    const QuadMeshResult b = meshed(shape, sources);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.quads, b.quads);
    EXPECT_EQ(a.row, b.row);
    EXPECT_EQ(a.patch, b.patch);
    EXPECT_EQ(a.node_input, b.node_input);
    EXPECT_EQ(a.line_edges, b.line_edges);
}

TEST(QuadMesh, UnusedPointsAreDropped) {
    shapes::Shape shape = shapes::grid(6, 6);
    shape.points.emplace_back(2, 2, 1);
    expect_good(shape, meshed(shape));
}

TEST(QuadMesh, UserEdgesAreCovered) {
    Options options;
    for (int i = 0; i < 8; ++i) options.feature_edges.push_back({4 * 9 + i, 4 * 9 + i + 1});
    const shapes::Shape shape = shapes::grid(8, 8);
    const QuadMeshResult result = meshed(shape, {}, options);
    expect_consistent(shape, result);
    double length = 0.0;
    for (const auto& [a, b, line] : result.line_edges) {
        const Point& p = result.points[static_cast<std::size_t>(a)];
        const Point& q = result.points[static_cast<std::size_t>(b)];
        if (std::abs(p.y() - 4.0) < 1e-9 && std::abs(q.y() - 4.0) < 1e-9) length += (p - q).norm();
    }
    EXPECT_NEAR(length, 8.0, 1e-9);
    EXPECT_EQ(result.report.patches, 2);
}

TEST(QuadMesh, StagesAreRecordedOnDemand) {
    const shapes::Shape shape = shapes::grid(30, 24);
    const std::vector<Source> sources{source(path(12 * 31, 12 * 31 + 30, 1), {{3, 0}, {2, 0}})};
    EXPECT_TRUE(meshed(shape, sources).stages.empty());
    Options options;
    options.record_stages = true;
    std::vector<std::string> names;
    for (const StageSnapshot& stage : meshed(shape, sources, options).stages) {
        names.push_back(stage.name);
        EXPECT_EQ(stage.row.size(), stage.faces.size());
        for (const auto& f : stage.faces) {
            for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(f[k], static_cast<std::int32_t>(stage.points.size()));
            EXPECT_GE(f[2], 0);
        }
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"pass 1: rows", "pass 1: merge", "pass 2: rows", "pass 2: merge", "fill", "result"}));
}

TEST(QuadMesh, ProgressRisesFromZeroToOne) {
    const shapes::Shape shape = shapes::grid(50, 50);
    const std::vector<Source> sources{source(path(25 * 51, 25 * 51 + 50, 1), {{3, 0}, {2, 0}, {2, 0}})};
    std::vector<double> fractions;
    std::vector<std::string> names;
    Context context([&](std::string_view stage, double fraction) {
        fractions.push_back(fraction);
        if (names.empty() || names.back() != stage) names.emplace_back(stage);
        return true;
    });
    quad_mesh(shape.points, shape.triangles, sources, {}, context);
    ASSERT_GT(fractions.size(), 10u);
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_GE(fractions.back(), 0.9);
    EXPECT_LE(fractions.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "a stage begins twice";
}

TEST(QuadMesh, CanBeCancelledAtAnyTime) {
    const shapes::Shape shape = shapes::grid(16, 16);
    const std::vector<Source> sources{source(path(8 * 17, 8 * 17 + 16, 1), {{2, 0}})};
    int calls = 0;
    Context counting([&](std::string_view, double) { return ++calls > 0; });
    quad_mesh(shape.points, shape.triangles, sources, {}, counting);
    for (int stop = 1; stop <= calls; stop += std::max(1, calls / 12)) {
        int n = 0;
        Context context([&](std::string_view, double) { return ++n < stop; });
        try {
            quad_mesh(shape.points, shape.triangles, sources, {}, context);
            FAIL() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::cancelled);
            EXPECT_EQ(n, stop);
        }
    }
}

// ---------------------------------------------------------------- bad input

void expect_error(ErrorCode code, const shapes::Shape& shape, const std::vector<Source>& sources = {},
                  const Options& options = {}) {
    try {
        meshed(shape, sources, options);
        FAIL() << "accepted, expected " << name(code);
    } catch (const Error& error) {
        EXPECT_EQ(name(error.code()), name(code));
        EXPECT_FALSE(std::string(error.what()).empty());
    }
}

TEST(QuadMesh, BadInputIsATypedError) {
    expect_error(ErrorCode::empty_mesh, {});
    shapes::Shape shape = shapes::grid(4, 4);
    shape.points[7].y() = std::numeric_limits<double>::quiet_NaN();
    expect_error(ErrorCode::non_finite_coordinates, shape);
    shape = shapes::grid(4, 4);
    shape.triangles[3][1] = 25;
    expect_error(ErrorCode::index_out_of_range, shape);
    shape = shapes::grid(4, 4);
    shape.triangles[3][1] = shape.triangles[3][0];
    expect_error(ErrorCode::degenerate_facets, shape);
    shape = shapes::grid(4, 4);
    shape.triangles.push_back(shape.triangles.front());
    expect_error(ErrorCode::duplicate_facets, shape);
    shape = shapes::grid(4, 4);
    std::swap(shape.triangles[3][0], shape.triangles[3][1]);
    expect_error(ErrorCode::inconsistent_orientation, shape);
    expect_error(ErrorCode::inconsistent_orientation, shapes::moebius(24, 4));
}

TEST(QuadMesh, BadSourcesAndOptionsAreTypedErrors) {
    const shapes::Shape shape = shapes::grid(8, 8);
    expect_error(ErrorCode::invalid_source, shape, {source({0, 40})});              // no edge
    expect_error(ErrorCode::invalid_source, shape, {source({0})});                  // no line
    expect_error(ErrorCode::invalid_source, shape, {source({0, 1, 2, 1})});         // touches itself
    expect_error(ErrorCode::invalid_source, shape, {source({0, 1, 500})});          // no vertex
    expect_error(ErrorCode::invalid_option, shape, {source({0, 1, 2}, {{0, 0}})});  // ratio
    Options options;
    options.feature_angle = -5.0;
    expect_error(ErrorCode::invalid_option, shape, {}, options);
    Options edges;
    edges.feature_edges = {{0, 40}};
    expect_error(ErrorCode::invalid_feature_edge, shape, {}, edges);
}

}  // namespace
}  // namespace anisoquad
