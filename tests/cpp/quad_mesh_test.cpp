#include "quad_mesh.h"

#include <gtest/gtest.h>

#include "quad_mesh_checks.h"

namespace anisoquad {
namespace {

using stages::path;
using stages::source;

// ---------------------------------------------------------------- without a source

TEST(QuadMesh, IsTheSameForAnyNumberOfThreads) {
    // More nodes than a block of the parallel loops has, so that the blocks meet.
    const shapes::Shape shape = shapes::torus(160, 80);
    Options options;
    options.threads = 1;
    const QuadMeshResult alone = quad_mesh(shape.points, shape.triangles, {}, options);
    ASSERT_GT(alone.points.size(), 4096u);
    for (const int threads : {2, 3, 0}) {
        options.threads = threads;
        const QuadMeshResult result = quad_mesh(shape.points, shape.triangles, {}, options);
        EXPECT_EQ(result.points, alone.points);
        EXPECT_EQ(result.quads, alone.quads);
        EXPECT_EQ(result.report.hausdorff, alone.report.hausdorff);
        EXPECT_EQ(result.report.scaled_jacobian.mean, alone.report.scaled_jacobian.mean);
    }
}

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

TEST(QuadMesh, TheTopOfAConeIsANode) {
    Options options;
    options.prepare = false;
    for (const double height : {0.5, 1.0, 2.0}) {
        const shapes::Shape cone = shapes::cone(14, 7, height);
        const QuadMeshResult result = meshed(cone, {}, options);
        expect_good(cone, result);
        EXPECT_NE(std::find(result.points.begin(), result.points.end(), cone.points.back()), result.points.end()) << height;
    }
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

/// Two walls that meet at an angle along an upright edge, and the wedge on top between them.
shapes::Shape thin_wedge(double degrees, int cells) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {0, 0, -1}};
    const double slope = std::tan(degrees * std::numbers::pi / 180.0);
    for (int i = 1; i <= cells; ++i) {
        const double x = 10.0 * i / cells;
        for (const double z : {0.0, -1.0}) {
            shape.points.emplace_back(x, 0.0, z);
            shape.points.emplace_back(x, slope * x, z);
        }
    }
    const auto point = [](int i, int side, int level) { return i == 0 ? level : 2 + 4 * (i - 1) + 2 * level + side; };
    for (int i = 0; i < cells; ++i) {
        if (i == 0) {
            shape.triangles.push_back({0, point(1, 0, 0), point(1, 1, 0)});
        } else {
            shape.add_quad(point(i, 0, 0), point(i + 1, 0, 0), point(i + 1, 1, 0), point(i, 1, 0));
        }
        shape.add_quad(point(i, 0, 0), point(i, 0, 1), point(i + 1, 0, 1), point(i + 1, 0, 0));
        shape.add_quad(point(i, 1, 0), point(i + 1, 1, 0), point(i + 1, 1, 1), point(i, 1, 1));
    }
    return shape;
}

TEST(QuadMesh, BetweenLinesThatMeetAtASmallAngleNoCornerIsFlat) {
    double shares = 0.0;  // of the lines' angle, that of the flattest corner
    int cases = 0;
    for (const double degrees : {0.4, 1.0, 2.0}) {
        for (const int cells : {10, 15, 26}) {
            SCOPED_TRACE(std::to_string(degrees) + "°, " + std::to_string(cells));
            const shapes::Shape shape = thin_wedge(degrees, cells);
            const QuadMeshResult result = quad_mesh(shape.points, shape.triangles, {});
            EXPECT_EQ(result.report.inverted, 0);
            const double share = result.report.scaled_jacobian.min / std::sin(degrees * std::numbers::pi / 180.0);
            EXPECT_GT(share, 0.48);  // two quads that share the corner have half of it each, but for a search's last step
            shares += share;
            ++cases;
        }
    }
    EXPECT_GT(shares / cases, 0.8);
}

/// A cube with a hair beside an edge: a sliver whose tip stands off the face by a rounding error, so that its normal is any.
shapes::Shape cube_with_sliver() {
    shapes::Shape shape = shapes::cube(6);
    const auto point = [&](std::int32_t v) -> const Point& { return shape.points[static_cast<std::size_t>(v)]; };
    for (auto& t : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b, c] = std::array{t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
            const Point along = point(b) - point(a);
            if (point(a).z() < 6.0 || point(b).z() < 6.0 || point(c).z() < 6.0) continue;
            if (point(a).y() > 0.0 || point(b).y() > 0.0 || along.x() == 0.0) continue;
            const auto tip = static_cast<std::int32_t>(shape.points.size());
            shape.points.push_back(point(a) + 0.5 * along + Point(0.0, 6e-6, 6e-6));
            t = {a, b, tip};
            shape.triangles.push_back({b, c, tip});
            shape.triangles.push_back({c, a, tip});
            return shape;
        }
    }
    return shape;
}

TEST(QuadMesh, ASliverIsNoPatchOfItsOwn) {
    const shapes::Shape shape = cube_with_sliver();
    ASSERT_EQ(shape.points.size(), shapes::cube(6).points.size() + 1);
    const QuadMeshResult result = meshed(shape);
    EXPECT_EQ(result.report.patches, 6);
    EXPECT_EQ(result.report.inverted, 0);
    EXPECT_GT(result.report.scaled_jacobian.min, 0.3);
    ASSERT_EQ(result.report.warnings.size(), 1U);
    EXPECT_EQ(result.report.warnings.front(),
              "the edges of 2 triangles were turned because some were thinner than 5e-05 of the diagonal");
}

TEST(QuadMesh, TwoNodesAHairApartBecomeOne) {
    shapes::Shape shape = shapes::cube(6);
    // The upper face's middle becomes two points, with a needle on either side of their edge.
    const auto middle =
        static_cast<std::int32_t>(std::find(shape.points.begin(), shape.points.end(), Point(3, 3, 6)) - shape.points.begin());
    ASSERT_LT(static_cast<std::size_t>(middle), shape.points.size());
    const auto beside = static_cast<std::int32_t>(shape.points.size());
    shape.points.emplace_back(3.0001, 3, 6);
    std::vector<std::int32_t> above, below;  // neighbours of the middle in its column
    for (auto& triangle : shape.triangles) {
        if (std::find(triangle.begin(), triangle.end(), middle) == triangle.end()) continue;
        double x = 0.0;
        for (std::int32_t& v : triangle) {
            const Point& p = shape.points[static_cast<std::size_t>(v)];
            x += p.x() / 3.0;
            if (v != middle && p.x() == 3) (p.y() > 3 ? above : below).push_back(v);
        }
        if (x > 3.0) std::replace(triangle.begin(), triangle.end(), middle, beside);
    }
    ASSERT_EQ(above.size(), 2U);
    shape.triangles.push_back({middle, beside, above[0]});
    shape.triangles.push_back({beside, middle, below[0]});
    const QuadMeshResult result = meshed(shape);
    EXPECT_EQ(result.report.inverted, 0);
    EXPECT_GT(result.report.scaled_jacobian.min, 0.5);
    ASSERT_EQ(result.report.warnings.size(), 1U);
    EXPECT_EQ(result.report.warnings.front(), "1 edges were collapsed because they are shorter than 5e-05 of the diagonal");
}

}  // namespace
}  // namespace anisoquad
