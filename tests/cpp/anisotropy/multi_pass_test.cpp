#include "anisotropy/multi_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "mesh/area_vector.h"
#include "mesh/arrays.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

/// A surface after all its passes.
struct Built : Prepared {
    std::vector<Source> sources;
    std::vector<std::string> observed;
    MultiPassResult result;

    Built(const shapes::Shape& of, const std::vector<Source>& lines, const Options& options = {})
        : Prepared(of, lines, options), sources(lines) {
        const LocalSize size(shape.points, shape.triangles, reference);
        result = build_anisotropic_rows(mesh, sources, size, reference, options,
                                        [&](const std::string& stage) { observed.push_back(stage); });
    }
    Built(const Built&) = delete;
};

std::vector<HalfEdge> source_halfedges(const SurfaceMesh& mesh) {
    std::vector<HalfEdge> all;
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        if (!mesh.is_deleted(HalfEdge(i)) && mesh.info(M::edge(HalfEdge(i))).source) all.emplace_back(i);
    }
    return all;
}

/// The quads over a source edge, from row 1 upwards.
std::vector<Face> column(const SurfaceMesh& mesh, HalfEdge base) {
    std::vector<Face> quads;
    while (!mesh.is_boundary(base) && mesh.is_quad(mesh.face(base)) && mesh.info(mesh.face(base)).row > 0) {
        quads.push_back(mesh.face(base));
        base = M::twin(mesh.next(mesh.next(base)));
    }
    return quads;
}

/// Length of the quad's edge towards the source over its mean height; `base` is that edge.
double aspect(const SurfaceMesh& mesh, HalfEdge base) {
    return mesh.length(base) / (0.5 * (mesh.length(mesh.next(base)) + mesh.length(mesh.prev(base))));
}

/// What holds whatever the surface: sound, no face but triangles and quads, rows counted from the source without a gap, nothing
/// folded, and the report agrees with the mesh.
void expect_rows(const Built& p) {
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    EXPECT_TRUE(p.result.warnings.empty());
    std::size_t in_columns = 0;
    for (const HalfEdge h : source_halfedges(p.mesh)) {
        const auto quads = column(p.mesh, h);
        in_columns += quads.size();
        for (std::size_t j = 0; j < quads.size(); ++j) {
            const FaceInfo& info = p.mesh.info(quads[j]);
            EXPECT_EQ(info.row, static_cast<int>(j) + 1);
            EXPECT_GE(info.pass, j > 0 ? p.mesh.info(quads[j - 1]).pass : 1);
            EXPECT_GE(info.source, 0);
        }
    }
    EXPECT_EQ(in_columns, static_cast<std::size_t>(quad_count(p.mesh)));
    for (const Face f : faces(p.mesh)) {
        if (!p.mesh.is_quad(f)) {
            EXPECT_EQ(p.mesh.info(f).row, 0);
            continue;
        }
        EXPECT_GT(scaled_jacobian(p.mesh, f, p.reference.closest(centre(p.mesh, f)).normal), 0.1);
        for (const HalfEdge h : p.mesh.halfedges(f)) EXPECT_TRUE(p.mesh.info(p.mesh.from(h)).in_row);
    }
    for (const PassReport& pass : p.result.passes) {
        EXPECT_FALSE(pass.stopped.empty());
        EXPECT_GE(pass.rows, 0);
        EXPECT_GT(pass.columns, 0);
        EXPECT_TRUE(pass.side == "left" || pass.side == "right");
    }
}

/// Rows that the report tells, all passes of a source's side.
int reported_rows(const Built& p, int source, const std::string& side) {
    int rows = 0;
    for (const PassReport& pass : p.result.passes) rows += pass.source == source && pass.side == side ? pass.rows : 0;
    return rows;
}

/// The half-edge of the source, on the given side, that lies over the place.
HalfEdge base_at(const SurfaceMesh& mesh, const Point& place, bool left) {
    HalfEdge best;
    double least = 1e300;
    for (const HalfEdge h : source_halfedges(mesh)) {
        const Eigen::Vector3d d = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
        const double distance = (0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))) - place).norm();
        if ((d.x() > 0.0) != left || distance >= least) continue;
        least = distance;
        best = h;
    }
    return best;
}

constexpr int kNx = 96;
constexpr int kNy = 84;

/// A line across the middle of a large plane.
std::vector<std::int32_t> middle() { return path((kNy / 2) * (kNx + 1), (kNy / 2) * (kNx + 1) + kNx, 1); }

/// The source's edge is 16 of the picked ones in the middle, and the mean aspect ratio falls from pass to pass.
/// @param tolerance share by which it may rise in between
void expect_product_of_16(const Built& p, double tolerance = 0.0) {
    for (const bool left : {true, false}) {
        const HalfEdge base = base_at(p.mesh, Point(kNx / 2.0, kNy / 2.0, 0.0), left);
        EXPECT_NEAR(p.mesh.length(base), 16.0, 1e-9);
        EXPECT_GT(aspect(p.mesh, base), 10.0);
        EXPECT_LT(aspect(p.mesh, base), 22.0);
        std::array<double, 3> sum{};
        std::array<int, 3> count{};
        HalfEdge h = base;
        for (const Face f : column(p.mesh, base)) {
            const auto pass = static_cast<std::size_t>(p.mesh.info(f).pass - 1);
            ASSERT_LT(pass, 3u);
            sum[pass] += aspect(p.mesh, h);
            ++count[pass];
            h = M::twin(p.mesh.next(p.mesh.next(h)));
        }
        for (const int n : count) ASSERT_GT(n, 0);
        EXPECT_GT(sum[0] / count[0], sum[1] / count[1]);
        EXPECT_GT((1.0 + tolerance) * sum[1] / count[1], sum[2] / count[2]);
        EXPECT_GT(sum[0] / count[0], sum[2] / count[2]);
    }
}

TEST(MultiPass, AnisotropiesMultiplyAndFallWithDistance) {
    const std::int32_t first = middle().front();
    Built inside(shapes::grid(kNx, kNy), {source(path(first + 20, first + kNx - 20, 1), {{4, 4}, {2, 3}, {2, 2}})});
    expect_rows(inside);
    expect_product_of_16(inside);
    // Where the rows end on lines, the lines' nodes hold their heights all but level.
    Built across(shapes::grid(kNx, kNy), {source(middle(), {{4, 4}, {2, 3}, {2, 2}})});
    expect_rows(across);
    expect_product_of_16(across, 0.02);
}

TEST(MultiPass, AsManyRowsAsFitLeaveRoomForThePassThatFollows) {
    // On triangles of one size the first pass takes nearly all the room, the third finds none ahead.
    Built p(shapes::grid(kNx, kNy), {source(middle(), {{4, 0}, {2, 0}, {2, 0}})});
    expect_rows(p);
    for (const bool left : {true, false}) {
        const HalfEdge base = base_at(p.mesh, Point(kNx / 2.0, kNy / 2.0, 0.0), left);
        EXPECT_GE(p.mesh.length(base), 8.0 - 1e-9);
        EXPECT_GT(aspect(p.mesh, base), 6.0);
    }
}

/// The growth is limited to that of the local size, but for the rows that lead over to isotropic quads.
TEST(MultiPass, TheLastRowsLeadOverToSquares) {
    const std::int32_t first = middle().front();
    const auto vertices = path(first + 20, first + kNx - 20, 1);
    for (const int ratio : {3, 4}) {
        Built p(shapes::grid(kNx, kNy), {source(vertices, {{ratio, 0}})});
        expect_rows(p);
        for (const bool left : {true, false}) {
            const auto quads = column(p.mesh, base_at(p.mesh, Point(kNx / 2.0, kNy / 2.0, 0.0), left));
            ASSERT_GT(quads.size(), 2u);
            std::vector<double> area;
            for (const Face f : quads) area.push_back(0.5 * doubled_area_vector_of_quad(p.mesh, f).norm());
            EXPECT_LT(ratio * ratio / area.back(), 2.2);  // a square over the merged edge
            for (std::size_t j = 1; j < area.size(); ++j) EXPECT_LT(area[j] / area[j - 1], 1.65);
        }
    }
    // A number of rows that was asked for is kept.
    Built asked(shapes::grid(kNx, kNy), {source(vertices, {{4, 3}})});
    EXPECT_EQ(column(asked.mesh, base_at(asked.mesh, Point(kNx / 2.0, kNy / 2.0, 0.0), true)).size(), 3u);
}

TEST(MultiPass, StagesAreObservedAndReported) {
    Built p(shapes::grid(48, 40), {source(path(20 * 49, 20 * 49 + 48, 1), {{3, 0}, {2, 0}})});
    EXPECT_EQ(p.observed, (std::vector<std::string>{"pass 1: rows", "pass 1: merge", "pass 2: rows", "pass 2: merge"}));
    ASSERT_EQ(p.result.passes.size(), 4u);
    expect_rows(p);
    for (const bool left : {true, false}) {
        const auto quads = column(p.mesh, base_at(p.mesh, Point(24, 20, 0), left));
        EXPECT_EQ(reported_rows(p, 0, left ? "left" : "right"), static_cast<int>(quads.size()));
    }
    for (const PassReport& pass : p.result.passes) EXPECT_EQ(pass.ratio, pass.pass == 1 ? 3 : 2);
}

TEST(MultiPass, BothSidesShareTheSourcesNodes) {
    Built p(shapes::grid(48, 40), {source(path(20 * 49, 20 * 49 + 48, 1), {{4, 0}})});
    expect_rows(p);
    for (const HalfEdge h : source_halfedges(p.mesh)) {
        EXPECT_TRUE(p.mesh.is_quad(p.mesh.face(h)));
        EXPECT_EQ(p.mesh.info(p.mesh.face(h)).row, 1);
    }
}

TEST(MultiPass, TheRowsAskedForAreBuilt) {
    Built p(shapes::grid(kNx, kNy), {source(middle(), {{4, 3}, {2, 2}})});
    expect_rows(p);
    ASSERT_EQ(p.result.passes.size(), 4u);
    for (const PassReport& pass : p.result.passes) EXPECT_EQ(pass.rows, pass.pass == 1 ? 3 : 2) << pass.stopped;
}

TEST(MultiPass, OneSideOnly) {
    for (const Sides sides : {Sides::left, Sides::right}) {
        Built p(shapes::grid(48, 40), {source(path(20 * 49, 20 * 49 + 48, 1), {{3, 0}, {2, 0}}, sides)});
        expect_rows(p);
        for (const PassReport& pass : p.result.passes) EXPECT_EQ(pass.side, sides == Sides::left ? "left" : "right");
        for (const Face f : faces(p.mesh)) {
            EXPECT_TRUE(!p.mesh.is_quad(f) || (centre(p.mesh, f).y() > 20.0) == (sides == Sides::left));
        }
        EXPECT_GT(quad_count(p.mesh), 0);
    }
}

TEST(MultiPass, SeveralSourcesStopBeforeEachOther) {
    Built p(shapes::grid(48, 60),
            {source(path(18 * 49, 18 * 49 + 48, 1), {{3, 0}, {2, 0}}), source(path(42 * 49, 42 * 49 + 48, 1), {{4, 0}})});
    expect_rows(p);
    for (const int s : {0, 1}) {
        for (const char* side : {"left", "right"}) EXPECT_GT(reported_rows(p, s, side), 0);
    }
    for (const Face f : faces(p.mesh)) {
        if (!p.mesh.is_quad(f)) continue;
        EXPECT_EQ(p.mesh.info(f).source, centre(p.mesh, f).y() < 30.0 ? 0 : 1);
    }
}

TEST(MultiPass, SourcesMayMeetAtTheirEnds) {
    // The rows of each end on the other line, whose nodes there are not merged.
    for (const int n : {20, 40}) {
        const std::int32_t centre = n / 2 * (n + 2);
        const auto right = path(centre, centre + n / 2, 1);
        const auto up = path(centre, centre + n / 2 * (n + 1), n + 1);
        for (const int ratio : {2, 4}) {
            Built p(shapes::grid(n, n), {source(right, {{ratio, 0}, {2, 0}}), source(up, {{ratio, 0}, {2, 0}})});
            expect_sound(p);
            EXPECT_EQ(inverted_triangles(p), 0);
            EXPECT_TRUE(p.result.warnings.empty());
            for (const int s : {0, 1}) EXPECT_GT(reported_rows(p, s, "left") + reported_rows(p, s, "right"), 0);
            for (const Face f : faces(p.mesh)) {
                EXPECT_EQ(p.mesh.is_quad(f), p.mesh.info(f).row > 0);
                if (p.mesh.info(f).row > 0) {
                    EXPECT_GT(scaled_jacobian(p.mesh, f), 0.1);
                }
            }
        }
    }
}

TEST(MultiPass, AClosedSourceHasNoRampAndAnEvenNumberOfSegments) {
    Built p(shapes::cylinder(48, 60, 1.0, 8.0), {source(ring(48, 30), {{4, 0}})});
    expect_rows(p);
    const auto bases = source_halfedges(p.mesh);
    ASSERT_FALSE(bases.empty());
    EXPECT_EQ(bases.size() / 2 % 2, 0u);
    double low = 1e300;
    double high = 0.0;
    for (const HalfEdge h : bases) {
        low = std::min(low, p.mesh.length(h));
        high = std::max(high, p.mesh.length(h));
        EXPECT_FALSE(column(p.mesh, h).empty());
    }
    EXPECT_LT(high, 2.1 * low);
}

TEST(MultiPass, ASourceMayEndInside) {
    Built p(shapes::grid(64, 60), {source(path(30 * 65 + 14, 30 * 65 + 50, 1), {{4, 0}, {2, 0}})});
    expect_rows(p);
    EXPECT_GT(reported_rows(p, 0, "left"), 1);
    EXPECT_GT(reported_rows(p, 0, "right"), 1);
    // Its ends stay where they are.
    EXPECT_EQ(p.mesh.position(Vertex(30 * 65 + 14)), Point(14, 30, 0));
    EXPECT_EQ(p.mesh.position(Vertex(30 * 65 + 50)), Point(50, 30, 0));
}

TEST(MultiPass, TheLineIsCoveredByItsMergedEdges) {
    Built p(shapes::grid(64, 60), {source(path(30 * 65, 30 * 65 + 64, 1), {{4, 0}, {2, 0}})});
    double length = 0.0;
    for (const HalfEdge h : source_halfedges(p.mesh)) {
        length += 0.5 * p.mesh.length(h);
        EXPECT_NEAR(p.mesh.position(p.mesh.from(h)).y(), 30.0, 1e-12);
        EXPECT_GE(p.mesh.info(p.mesh.from(h)).input, 0);  // nodes of the source are a part of the picked ones
    }
    EXPECT_NEAR(length, 64.0, 1e-9);
}

TEST(MultiPass, MergedEdgesDoNotCutOffBends) {
    const int n = 64;
    shapes::Shape shape = shapes::grid(n, 40);
    for (Point& q : shape.points) q.y() += 3.0 * std::sin(2.0 * std::numbers::pi * q.x() / 32.0);
    const auto line = path(20 * (n + 1), 20 * (n + 1) + n, 1);
    Built p(shape, {source(line, {{4, 0}, {2, 0}})});
    expect_rows(p);
    // Every picked point is closer to the source's edges of now than a part of the first row's height.
    for (const std::int32_t v : line) {
        double nearest = 1e300;
        for (const HalfEdge h : source_halfedges(p.mesh)) {
            const Point& a = p.mesh.position(p.mesh.from(h));
            const Eigen::Vector3d d = p.mesh.position(p.mesh.to(h)) - a;
            const double t = std::clamp(d.dot(p.shape.points[static_cast<std::size_t>(v)] - a) / d.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (a + t * d - p.shape.points[static_cast<std::size_t>(v)]).norm());
        }
        EXPECT_LT(nearest, 0.3);
    }
}

TEST(MultiPass, WhereNoRowFitsNothingIsMerged) {
    Built p(shapes::grid(20, 1), {source(path(0, 20, 1), {{4, 0}, {2, 0}})});
    expect_sound(p);
    EXPECT_EQ(quad_count(p.mesh), 0);
    EXPECT_EQ(p.mesh.vertex_count(), 42);
    ASSERT_FALSE(p.result.passes.empty());
    for (const PassReport& pass : p.result.passes) {
        EXPECT_EQ(pass.rows, 0);
        EXPECT_FALSE(pass.stopped.empty());
    }
}

/// A hole one cell beside a source along the middle, over the columns 44 to 52 of 96.
shapes::Shape plane_with_hole() {
    return shapes::grid_with_holes(96, 48, [](int i, int j) { return i < 44 || i >= 52 || j < 25 || j >= 27; });
}

TEST(MultiPass, RowsGoOnBesideWhatIsInTheWayOfAFewColumns) {
    Built p(plane_with_hole(), {source(path(24 * 97, 24 * 97 + 96, 1), {{4, 0}})});
    expect_rows(p);
    EXPECT_EQ(column(p.mesh, base_at(p.mesh, Point(48, 24, 0), true)).size(), 0u);
    for (const double x : {20.0, 76.0}) {
        const HalfEdge base = base_at(p.mesh, Point(x, 24, 0), true);
        EXPECT_GE(column(p.mesh, base).size(), 3u);
        EXPECT_NEAR(p.mesh.length(base), 4.0, 1e-9);
    }
    ASSERT_EQ(p.result.passes.size(), 4u);  // three parts on the left, the whole right
    EXPECT_EQ(p.result.passes[1].rows, 0);
    EXPECT_EQ(p.result.passes[1].stopped, "a boundary, a feature line or another row is too close ahead");
}

TEST(MultiPass, WhereNoSideGainedRowsTheSourceIsNotMerged) {
    Built p(plane_with_hole(), {source(path(24 * 97, 24 * 97 + 96, 1), {{4, 0}, {2, 0}}, Sides::left)});
    expect_rows(p);
    for (const double x : {46.5, 48.5, 50.5}) EXPECT_NEAR(p.mesh.length(base_at(p.mesh, Point(x, 24, 0), true)), 1.0, 1e-9);
    EXPECT_NEAR(p.mesh.length(base_at(p.mesh, Point(20, 24, 0), true)), 8.0, 1e-9);
}

TEST(MultiPass, TheSameInputGivesTheSameMesh) {
    const shapes::Shape shape = shapes::sphere(48, 32);
    const std::vector<Source> lines{source(path(15 * 48 + 2, 15 * 48 + 30, 1), {{3, 0}, {2, 0}})};
    Built a(shape, lines);
    Built b(shape, lines);
    expect_rows(a);
    EXPECT_EQ(to_arrays(a.mesh).faces, to_arrays(b.mesh).faces);
    EXPECT_EQ(to_arrays(a.mesh).points, to_arrays(b.mesh).points);
}

TEST(MultiPass, ALineThatMeetsTheSourceOnASideWithoutRowsStaysStraight) {
    const shapes::Shape shape = shapes::grid(16, 8);
    Source line = source(path(4 * 17, 4 * 17 + 16, 1), {{4, 1}});
    line.sides = Sides::left;
    for (std::int32_t column = 3; column < 14; ++column) {
        Options options;
        for (std::int32_t j = 0; j < 4; ++j) options.feature_edges.push_back({17 * j + column, 17 * (j + 1) + column});
        Built b(shape, {line}, options);
        double length = 0.0;
        for (std::int32_t i = 0; i < b.mesh.edge_slots(); ++i) {
            if (!b.mesh.is_deleted(Edge(i)) && b.mesh.info(Edge(i)).line >= 0) length += b.mesh.length(Edge(i));
        }
        EXPECT_NEAR(length, 2 * (16 + 8) + 16 + 4, 1e-9) << column;
    }
}

TEST(MultiPass, CanBeCancelled) {
    Prepared p(shapes::grid(20, 20), {source(path(210, 230, 1))});
    const LocalSize size(p.shape.points, p.shape.triangles, p.reference);
    Context context([](std::string_view, double) { return false; });
    const std::vector<Source> lines{source(path(210, 230, 1))};
    EXPECT_THROW(build_anisotropic_rows(p.mesh, lines, size, p.reference, {}, {}, context), Error);
}

}  // namespace
}  // namespace anisoquad
