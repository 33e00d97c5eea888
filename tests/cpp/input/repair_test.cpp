#include "input/repair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "input/check.h"
#include "mesh/validate.h"
#include "quad_mesh.h"
#include "shapes.h"
#include "stages.h"

namespace anisoquad {
namespace {

using shapes::Shape;
using Ids = std::vector<std::int32_t>;

Shape shape_of(const RepairResult& r) { return {r.points, r.triangles}; }

/// The repaired surface, which has to pass the check.
RepairResult repaired(const Shape& shape, const std::vector<Source>& sources = {}) {
    RepairResult result = repair_surface(shape.points, shape.triangles, sources);
    EXPECT_NO_THROW(check_input(result.points, result.triangles));
    EXPECT_EQ(result.origin.size(), result.points.size());
    return result;
}

/// Every triangle with its own vertices, as in an STL file.
Shape soup(const Shape& shape) {
    Shape result;
    for (const auto& t : shape.triangles) {
        const auto first = static_cast<std::int32_t>(result.points.size());
        for (const std::int32_t v : t) result.points.push_back(shape.points[static_cast<std::size_t>(v)]);
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

double volume(const RepairResult& r) {
    double sum = 0.0;
    for (const auto& t : r.triangles) {
        const auto p = [&](std::size_t k) -> const Point& { return r.points[static_cast<std::size_t>(t[k])]; };
        sum += p(0).cross(p(1)).dot(p(2)) / 6.0;
    }
    return sum;
}

void expect_same_surface(const RepairResult& r, const Shape& shape) {
    EXPECT_EQ(topology(shape_of(r).mesh()), topology(shape.mesh()));
    EXPECT_NEAR(stages::input_area(shape_of(r)), stages::input_area(shape), 1e-9 * stages::input_area(shape));
}

TEST(Repair, LeavesAValidSurfaceAsItIs) {
    for (const Shape& shape : {shapes::grid(4, 3), shapes::torus(9, 5), shapes::cube(2), shapes::roof(3, 2, 60.0)}) {
        const RepairResult r = repaired(shape);
        EXPECT_EQ(r.report, RepairReport{});
        EXPECT_EQ(r.triangles, shape.triangles);
        EXPECT_EQ(r.points, shape.points);
        EXPECT_TRUE(summary(r.report).empty());
    }
}

TEST(Repair, WeldsATriangleSoupOfAnySizeAnywhere) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Shape whole = shapes::placed(shapes::torus(12, 8), scale, 100.0 * scale * Point(1, -2, 3));
        const RepairResult r = repaired(soup(whole));
        expect_same_surface(r, whole);
        EXPECT_EQ(r.report.welded_vertices, 3 * static_cast<std::int32_t>(whole.triangles.size()) - 96);
    }
}

TEST(Repair, WeldsVerticesThatRoundingMoved) {
    Shape rounded = soup(shapes::sphere(12, 8));
    for (std::size_t i = 0; i < rounded.points.size(); ++i) rounded.points[i] += 1e-8 * Point(i % 3, i % 5, i % 7) / 7.0;
    EXPECT_EQ(topology(shape_of(repaired(rounded)).mesh()), topology(shapes::sphere(12, 8).mesh()));
}

TEST(Repair, KeepsClosedSurfacesApartThatTouch) {
    const Shape pair = shapes::joined(shapes::cube(2), shapes::placed(shapes::cube(2), 1.0, {2, 0, 0}));
    const RepairResult r = repaired(pair);
    EXPECT_EQ(r.report, RepairReport{});
    EXPECT_EQ(topology(shape_of(r).mesh()).components, 2);
}

TEST(Repair, DropsASecondCopyOfTheSurface) {
    const Shape grid = shapes::grid(4, 3);
    const RepairResult r = repaired(shapes::joined(grid, grid));
    expect_same_surface(r, grid);
    EXPECT_EQ(r.report.duplicate_facets, 24);
}

TEST(Repair, DropsFacetsThatHaveNoPlace) {
    Shape shape = shapes::grid(4, 4);
    shape.triangles[1][0] = -1;
    shape.triangles[20][2] = 1000;
    shape.points[12].x() = std::numeric_limits<double>::quiet_NaN();  // the middle: eight facets or four, and none else
    const RepairResult r = repaired(shape);
    EXPECT_EQ(r.report.out_of_range_facets, 2);
    EXPECT_GE(r.report.non_finite_facets, 4);
    EXPECT_EQ(r.triangles.size() + 2 + static_cast<std::size_t>(r.report.non_finite_facets), shape.triangles.size());
    EXPECT_TRUE(std::all_of(r.points.begin(), r.points.end(), [](const Point& p) { return p.allFinite(); }));
}

TEST(Repair, DropsDuplicateFacetsTurnedEitherWay) {
    const Shape grid = shapes::grid(3, 3);
    Shape shape = grid;
    const auto t = shape.triangles[4];
    shape.triangles.push_back({t[1], t[2], t[0]});
    shape.triangles.push_back({t[0], t[2], t[1]});
    const RepairResult r = repaired(shape);
    expect_same_surface(r, grid);
    EXPECT_EQ(r.report.duplicate_facets, 2);
}

TEST(Repair, CollapsesNeedlesWithoutAHole) {
    // The node (2, 2) is split in two that are all but at one place.
    Shape shape = shapes::grid(4, 4);
    const auto twin = static_cast<std::int32_t>(shape.points.size());
    shape.points.push_back(shape.points[12] + Point(1e-12, 0, 0));
    // Facets on its right take the twin; two needles between them fill the gap above and below.
    std::set<std::int32_t> shared;
    for (auto& t : shape.triangles) {
        double x = 0.0;
        for (const std::int32_t v : t) x += shape.points[static_cast<std::size_t>(v)].x() / 3.0;
        for (auto& v : t) v = v == 12 && x > 2.0 ? twin : v;
    }
    shape.triangles.push_back({12, twin, 17});
    shape.triangles.push_back({twin, 12, 7});
    EXPECT_THROW(check_input(shape.points, shape.triangles), Error);
    const RepairResult r = repaired(shape);
    expect_same_surface(r, shapes::grid(4, 4));
    EXPECT_EQ(r.report.degenerate_facets, 2);
}

TEST(Repair, CutsTheNeighbourOfACapInTwo) {
    // A T-junction filled by a facet without area: 0 – 1 – 2 on one line, the facet above hangs on 0 – 2.
    Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}};
    shape.triangles = {{0, 2, 3}, {0, 1, 2}, {0, 4, 1}, {1, 4, 2}};
    EXPECT_THROW(check_input(shape.points, shape.triangles), Error);
    const RepairResult r = repaired(shape, {stages::source({0, 2})});
    EXPECT_EQ(r.report.degenerate_facets, 1);
    EXPECT_EQ(r.triangles.size(), 4u);
    EXPECT_EQ(topology(shape_of(r).mesh()), (Topology{1, 1, 1}));
    EXPECT_EQ(r.sources[0].vertices, (Ids{0, 1, 2}));
}

TEST(Repair, RemovesFacetsWithoutAreaThatHangOnAnEdge) {
    Shape shape = shapes::torus(9, 5);
    const Shape torus = shape;
    shape.points.push_back(0.5 * (shape.points[0] + shape.points[1]));
    shape.triangles.push_back({0, 1, static_cast<std::int32_t>(shape.points.size()) - 1});
    shape.triangles.push_back({3, 3, 4});
    const RepairResult r = repaired(shape);
    expect_same_surface(r, torus);
    EXPECT_EQ(r.report.degenerate_facets, 2);
}

TEST(Repair, TurnsFacetsToOneOrientationAndClosedSurfacesOutwards) {
    std::mt19937 random(7);
    for (const Shape& right : {shapes::sphere(12, 8), shapes::cube(4)}) {
        Shape shape = right;
        for (auto& t : shape.triangles) {
            if (random() % 2) std::swap(t[1], t[2]);
        }
        const RepairResult r = repaired(shape);
        expect_same_surface(r, right);
        EXPECT_GT(volume(r), 0.0);
        std::int32_t turned = 0;
        for (std::size_t f = 0; f < shape.triangles.size(); ++f) turned += shape.triangles[f] != r.triangles[f];
        EXPECT_EQ(r.report.flipped_facets, turned);
    }
    Shape inside_out = shapes::torus(9, 5);
    for (auto& t : inside_out.triangles) std::swap(t[1], t[2]);
    const RepairResult r = repaired(inside_out);
    EXPECT_EQ(r.report.flipped_facets, static_cast<std::int32_t>(inside_out.triangles.size()));
    EXPECT_GT(volume(r), 0.0);
}

TEST(Repair, TurnsTheFewerFacetsOfAnOpenSurface) {
    Shape shape = shapes::grid(5, 5);
    for (const std::size_t f : {3u, 4u, 17u, 30u}) std::swap(shape.triangles[f][1], shape.triangles[f][2]);
    const RepairResult r = repaired(shape);
    EXPECT_EQ(r.report.flipped_facets, 4);
    for (const auto& t : r.triangles) {
        const auto p = [&](std::size_t k) -> const Point& { return r.points[static_cast<std::size_t>(t[k])]; };
        EXPECT_GT((p(1) - p(0)).cross(p(2) - p(0)).z(), 0.0);
    }
}

TEST(Repair, CutsAOneSidedSurfaceOpen) {
    const Shape band = shapes::moebius(20, 3);
    const RepairResult r = repaired(band);
    EXPECT_EQ(topology(shape_of(r).mesh()), (Topology{1, 1, 1}));  // a disk
    EXPECT_EQ(r.report.cut_edges, 3);
    EXPECT_EQ(r.report.new_vertices, 4);
    EXPECT_EQ(r.triangles.size(), band.triangles.size());
}

TEST(Repair, CutsApartWhatMeetsAtAnEdge) {
    Shape fan = shapes::grid(2, 1);
    fan.points.emplace_back(1.0, 0.5, 1.0);
    fan.triangles.push_back({1, 4, 6});  // a rib on the middle edge
    const RepairResult rib = repaired(fan);
    EXPECT_EQ(rib.report.cut_edges, 1);
    EXPECT_EQ(topology(shape_of(rib).mesh()).components, 2);
    EXPECT_EQ(topology(shape_of(rib).mesh()).boundary_loops, 2);

    // Two cubes that share an edge come apart as two closed cubes.
    Shape cubes = shapes::joined(shapes::cube(1), shapes::placed(shapes::cube(1), 1.0, {1, 1, 0}));
    for (auto& t : cubes.triangles) {
        for (auto& v : t) {
            for (std::int32_t w = 0; w < v; ++w) {
                if (cubes.points[static_cast<std::size_t>(w)] == cubes.points[static_cast<std::size_t>(v)]) v = w;
            }
        }
    }
    const RepairResult apart = repaired(cubes);
    EXPECT_EQ(apart.report.cut_edges, 1);
    EXPECT_EQ(topology(shape_of(apart).mesh()), (Topology{2, 0, 4}));
    EXPECT_NEAR(volume(apart), 2.0, 1e-12);
}

TEST(Repair, SplitsVerticesThatJoinPartsWithoutAnEdge) {
    const Shape holes = shapes::grid_with_holes(4, 4, [](int i, int j) { return !((i == 1 && j == 1) || (i == 2 && j == 2)); });
    const RepairResult r = repaired(holes);
    EXPECT_EQ(r.report.new_vertices, 1);
    EXPECT_EQ(r.origin.back(), 12);
    EXPECT_EQ(r.points.back(), holes.points[12]);
}

TEST(Repair, SourcesSurviveWelding) {
    const Shape grid = shapes::grid(6, 4);
    Shape shape = soup(grid);
    const auto at_place = [&](const Point& p, bool last) {
        std::int32_t found = -1;
        for (std::size_t v = 0; v < shape.points.size(); ++v) {
            if (shape.points[v] == p && (found < 0 || last)) found = static_cast<std::int32_t>(v);
        }
        return found;
    };
    Ids line;
    for (int i = 0; i <= 6; ++i) {  // both copies of every vertex of the middle line
        line.push_back(at_place(Point(i, 2, 0), false));
        line.push_back(at_place(Point(i, 2, 0), true));
    }
    const RepairResult r = repaired(shape, {stages::source(line)});
    ASSERT_EQ(r.sources[0].vertices.size(), 7u);
    EXPECT_NO_THROW(check_sources(shape_of(r).mesh(), r.sources));
}

TEST(Repair, SourcesDoNotGoToTheEndOfAWeldedSlitAndBack) {
    Shape shape = shapes::grid(2, 2);
    shape.points.push_back(shape.points[1]);  // the edge 1-4 is a slit
    for (auto& t : shape.triangles) {
        if (std::find(t.begin(), t.end(), 2) != t.end()) std::replace(t.begin(), t.end(), 1, 9);
    }
    Source source;
    source.vertices = {0, 1, 4, 9, 2};
    ASSERT_NO_THROW(check_sources(shape.mesh(), std::vector<Source>{source}));
    const RepairResult r = repaired(shape, {source});
    EXPECT_EQ(r.sources[0].vertices, (Ids{0, 1, 2}));
    EXPECT_NO_THROW(check_sources(shape_of(r).mesh(), r.sources));
}

TEST(Repair, SourcesTakeTheSideOfACutThatTheyLieOn) {
    const Shape band = shapes::moebius(20, 4);  // cut at column 0
    Ids towards_cut;
    for (int i = 15; i <= 20; ++i) towards_cut.push_back(i % 20 * 5 + 2);
    const RepairResult r = repaired(band, {stages::source(towards_cut), stages::source({2, 7, 12})});
    EXPECT_NO_THROW(check_sources(shape_of(r).mesh(), r.sources));
    EXPECT_NE(r.sources[0].vertices.back(), r.sources[1].vertices.front());
    EXPECT_EQ(r.origin[static_cast<std::size_t>(r.sources[0].vertices.back())], 2);
    EXPECT_EQ(r.origin[static_cast<std::size_t>(r.sources[1].vertices.front())], 2);
}

TEST(Repair, MeshesWhatItMended) {
    Shape shape = soup(shapes::cube(4));
    std::swap(shape.triangles[7][0], shape.triangles[7][1]);
    shape.triangles.push_back({0, 0, 1});
    Options options;
    options.repair = true;
    options.validate = true;
    const QuadMeshResult result = quad_mesh(shape.points, shape.triangles, {}, options);
    EXPECT_EQ(result.report.triangles_left, 0);
    EXPECT_EQ(result.report.inverted, 0);
    EXPECT_EQ(result.report.euler_out, 2);
    EXPECT_EQ(result.report.repair.flipped_facets, 1);
    EXPECT_EQ(result.report.repair.degenerate_facets, 1);
    ASSERT_FALSE(result.report.warnings.empty());
    EXPECT_NE(result.report.warnings[0].find("welded"), std::string::npos);
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        if (result.node_input[i] < 0) continue;
        EXPECT_EQ(result.points[i], shape.points[static_cast<std::size_t>(result.node_input[i])]);
    }
}

TEST(Repair, SaysWhenNothingIsLeft) {
    Shape shape = shapes::grid(1, 1);
    for (Point& p : shape.points) p.z() = std::numeric_limits<double>::infinity();
    Options options;
    options.repair = true;
    try {
        quad_mesh(shape.points, shape.triangles, {}, options);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::empty_mesh);
    }
}

/// Facets thrown together at random: whatever comes out must pass the check.
TEST(Repair, MakesAnythingAManifold) {
    std::mt19937 random(1);
    const auto below = [&](unsigned n) { return static_cast<std::int32_t>(random() % n); };
    for (int n = 0; n < 3000; ++n) {
        Shape shape;
        const unsigned points = 3 + random() % 12;
        for (unsigned i = 0; i < points; ++i) shape.points.emplace_back(below(4), below(4), below(3));
        const unsigned facets = 1 + random() % 30;
        for (unsigned f = 0; f < facets; ++f) shape.triangles.push_back({below(points), below(points), below(points)});
        const RepairResult r = repair_surface(shape.points, shape.triangles);
        if (r.triangles.empty()) continue;
        ASSERT_NO_THROW(check_input(r.points, r.triangles)) << "surface " << n;
        ASSERT_TRUE(validate(shape_of(r).mesh()).empty()) << "surface " << n;
    }
}

}  // namespace
}  // namespace anisoquad
