#include "input/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "errors.h"
#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using shapes::Shape;
using Ids = std::vector<std::int32_t>;

void expect_valid(const Shape& shape) {
    EXPECT_NO_THROW(check_input(shape.points, shape.triangles));
    EXPECT_TRUE(validate(shape.mesh()).empty());
}

template <class Function>
void expect_error(Function f, ErrorCode code, ElementKind kind, const Ids& ids) {
    try {
        f();
        FAIL() << "no error, expected " << name(code);
    } catch (const Error& error) {
        EXPECT_EQ(name(error.code()), name(code));
        EXPECT_EQ(name(error.kind()), name(kind));
        EXPECT_EQ(error.ids(), ids);
        EXPECT_GT(std::string(error.what()).size(), 20u);
    }
}

void expect_rejected(const Shape& shape, ErrorCode code, ElementKind kind, const Ids& ids) {
    expect_error([&] { check_input(shape.points, shape.triangles); }, code, kind, ids);
}

TEST(CheckInput, AcceptsEveryKindOfManifoldSurface) {
    expect_valid(shapes::grid(1, 1));
    expect_valid(shapes::grid(7, 4));
    expect_valid(shapes::grid_with_holes(7, 7, [](int i, int j) { return i != 3 || j != 3; }));
    expect_valid(shapes::cylinder(9, 3));
    expect_valid(shapes::sphere(8, 6));
    expect_valid(shapes::torus(9, 5));
    expect_valid(shapes::cube(3));
    expect_valid(shapes::joined(shapes::cube(2), shapes::placed(shapes::sphere(6, 5), 1.0, {9, 0, 0})));
}

TEST(CheckInput, DoesNotDependOnSizeAndPosition) {
    for (const double scale : {1e-9, 1e-6, 1e6, 1e12}) {
        const double far = 1e4 * scale;
        expect_valid(shapes::placed(shapes::torus(9, 5), scale, {far, -far, far}));
    }
}

TEST(CheckInput, RejectsAnEmptyMesh) {
    expect_rejected({}, ErrorCode::empty_mesh, ElementKind::none, {});
    Shape points_only = shapes::grid(1, 1);
    points_only.triangles.clear();
    expect_rejected(points_only, ErrorCode::empty_mesh, ElementKind::none, {});
}

TEST(CheckInput, RejectsCoordinatesThatAreNotFinite) {
    Shape shape = shapes::grid(3, 3);
    shape.points[2].y() = std::numeric_limits<double>::quiet_NaN();
    shape.points[7].z() = std::numeric_limits<double>::infinity();
    expect_rejected(shape, ErrorCode::non_finite_coordinates, ElementKind::vertex, {2, 7});
}

TEST(CheckInput, RejectsIndicesOutOfRange) {
    Shape shape = shapes::grid(3, 3);
    shape.triangles[1][0] = -1;
    shape.triangles[5][2] = 16;
    expect_rejected(shape, ErrorCode::index_out_of_range, ElementKind::facet, {1, 5});
}

TEST(CheckInput, RejectsFacetsWithoutArea) {
    Shape shape = shapes::grid(3, 3);
    const auto facets = static_cast<std::int32_t>(shape.triangles.size());
    shape.triangles.push_back({4, 4, 5});  // a repeated corner
    shape.triangles.push_back({0, 1, 2});  // on one line
    shape.points.push_back(shape.points[5]);
    shape.triangles.push_back({5, 16, 9});  // two points at one place
    expect_rejected(shape, ErrorCode::degenerate_facets, ElementKind::facet, {facets, facets + 1, facets + 2});
}

TEST(CheckInput, RejectsFacetsThatAreAPointBesideTheModel) {
    const Shape far = shapes::joined(shapes::grid(1, 1), shapes::placed(shapes::grid(1, 1), 1.0, {1e14, 0, 0}));
    expect_rejected(far, ErrorCode::degenerate_facets, ElementKind::facet, {0, 1, 2, 3});
    expect_valid(shapes::joined(shapes::grid(1, 1), shapes::placed(shapes::grid(1, 1), 1.0, {1e9, 0, 0})));
}

TEST(CheckInput, KeepsThinFacets) { expect_valid(shapes::grid(3, 3, 1.0, 1e-5)); }

TEST(CheckInput, RejectsDuplicateFacets) {
    Shape shape = shapes::grid(3, 3);
    const auto facets = static_cast<std::int32_t>(shape.triangles.size());
    const auto t = shape.triangles[4];
    const auto s = shape.triangles[7];
    shape.triangles.push_back({t[1], t[2], t[0]});
    shape.triangles.push_back({s[0], s[2], s[1]});  // turned over
    expect_rejected(shape, ErrorCode::duplicate_facets, ElementKind::facet, {facets, facets + 1});
}

TEST(CheckInput, RejectsEdgesWithThreeFacets) {
    Shape shape = shapes::grid(2, 2);
    shape.points.emplace_back(1.0, 1.0, 1.0);
    shape.triangles.push_back({4, 3, 9});
    expect_rejected(shape, ErrorCode::non_manifold_edges, ElementKind::edge, {3, 4});
}

TEST(CheckInput, RejectsVerticesWithTwoFans) {
    // two holes that touch at the node (2, 2)
    expect_rejected(shapes::grid_with_holes(4, 4, [](int i, int j) { return !((i == 1 && j == 1) || (i == 2 && j == 2)); }),
                    ErrorCode::non_manifold_vertices, ElementKind::vertex, {12});
    // two closed surfaces that share a vertex
    Shape pair = shapes::joined(shapes::cube(1), shapes::placed(shapes::cube(1), 1.0, {1, 1, 1}));
    const auto at_corner = [](const Point& p) { return (p - Point(1, 1, 1)).norm() < 1e-12; };
    const auto first =
        static_cast<std::int32_t>(std::find_if(pair.points.begin(), pair.points.end(), at_corner) - pair.points.begin());
    for (auto& t : pair.triangles) {
        for (auto& v : t) v = at_corner(pair.points[static_cast<std::size_t>(v)]) ? first : v;
    }
    expect_rejected(pair, ErrorCode::non_manifold_vertices, ElementKind::vertex, {first});
}

TEST(CheckInput, NamesTheFacetsThatAreTurned) {
    Shape shape = shapes::sphere(8, 6);
    for (const std::size_t f : {3u, 4u, 17u}) std::swap(shape.triangles[f][0], shape.triangles[f][1]);
    expect_rejected(shape, ErrorCode::inconsistent_orientation, ElementKind::facet, {3, 4, 17});
}

TEST(CheckInput, RejectsOneSidedSurfaces) {
    const Shape shape = shapes::moebius(12, 2);
    try {
        check_input(shape.points, shape.triangles);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::inconsistent_orientation);
        EXPECT_EQ(error.kind(), ElementKind::edge);
        EXPECT_EQ(error.ids().size(), 4u);  // the two edges across the band where the seam is
    }
}

TEST(CheckInput, ListsAtMostAThousandElements) {
    Shape shape = shapes::grid(40, 40);
    for (Point& p : shape.points) p.y() = 0.0;
    try {
        check_input(shape.points, shape.triangles);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.ids().size(), 1000u);
        EXPECT_NE(std::string(error.what()).find("3200"), std::string::npos);
    }
}

// The grid of the source tests: point (i, j) is 5·j + i.
class CheckSources : public ::testing::Test {
  protected:
    static Source line(Ids vertices) { return {std::move(vertices), {}, Sides::both}; }
    void expect_good(const std::vector<Source>& sources) const { EXPECT_NO_THROW(check_sources(mesh_, sources)); }
    void expect_bad(const std::vector<Source>& sources, ElementKind kind, const Ids& ids) const {
        expect_error([&] { check_sources(mesh_, sources); }, ErrorCode::invalid_source, kind, ids);
    }
    const SurfaceMesh mesh_ = shapes::grid(4, 4).mesh();
};

TEST_F(CheckSources, AcceptsPathsLoopsAndSharedEnds) {
    expect_good({});
    expect_good({line({10, 11, 12, 13, 14})});
    expect_good({line({6, 7, 8, 13, 18, 17, 16, 11, 6})});
    expect_good({line({10, 11, 12}), line({12, 13, 14}), line({2, 7, 12})});
    expect_good({line({0, 1, 2, 3, 4}), line({10, 11})});
}

TEST_F(CheckSources, RejectsWhatIsNoPathOfEdges) {
    expect_bad({line({})}, ElementKind::vertex, {});
    expect_bad({line({7})}, ElementKind::vertex, {7});
    expect_bad({line({10, 11, 25})}, ElementKind::vertex, {25});
    expect_bad({line({10, 12})}, ElementKind::edge, {10, 12});
    expect_bad({line({10, 11, 11})}, ElementKind::edge, {11, 11});
}

TEST_F(CheckSources, RejectsContacts) {
    expect_bad({line({10, 11, 10})}, ElementKind::edge, {11, 10});
    expect_bad({line({10, 11, 12, 7, 6, 11})}, ElementKind::vertex, {11});                      // ends on itself
    expect_bad({line({5, 6, 7, 12, 11, 6, 1})}, ElementKind::vertex, {6});                      // crosses itself
    expect_bad({line({10, 11, 12, 13, 14}), line({2, 7, 12, 17})}, ElementKind::vertex, {12});  // cross
    expect_bad({line({10, 11, 12, 13, 14}), line({2, 7, 12})}, ElementKind::vertex, {12});      // one ends inside the other
    expect_bad({line({2, 7, 12}), line({10, 11, 12, 13, 14})}, ElementKind::vertex, {12});
    expect_bad({line({11, 12}), line({12, 11})}, ElementKind::edge, {12, 11});
}

TEST_F(CheckSources, RejectsImpossiblePasses) {
    Source source = line({10, 11, 12});
    source.passes = {{0, 0}};
    expect_error([&] { check_sources(mesh_, std::vector<Source>{source}); }, ErrorCode::invalid_option, ElementKind::none, {});
    source.passes = {{2, -1}};
    expect_error([&] { check_sources(mesh_, std::vector<Source>{source}); }, ErrorCode::invalid_option, ElementKind::none, {});
    source.passes = {{4, 3}, {1, 0}};
    expect_good({source});
}

TEST(CheckOptions, RejectsValuesOutOfRange) {
    const auto with = [](auto set) {
        Options options;
        set(options);
        return options;
    };
    EXPECT_NO_THROW(check_options({}));
    const std::vector<Options> bad{
        with([](Options& o) { o.feature_angle = 0.0; }),
        with([](Options& o) { o.feature_angle = std::numeric_limits<double>::quiet_NaN(); }),
        with([](Options& o) { o.row_growth = 0.9; }),
        with([](Options& o) { o.smoothing_passes = -1; }),
        with([](Options& o) { o.threads = -1; }),
    };
    for (const Options& options : bad) {
        expect_error([&] { check_options(options); }, ErrorCode::invalid_option, ElementKind::none, {});
    }
}

TEST(CheckFeatureEdges, RejectsWhatIsNoEdge) {
    const SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    std::vector<std::array<std::int32_t, 2>> edges{{0, 1}, {4, 3}, {0, 8}, {0, 9}};
    expect_error([&] { check_feature_edges(mesh, edges); }, ErrorCode::invalid_feature_edge, ElementKind::edge, {0, 8, 0, 9});
    edges.resize(2);
    EXPECT_NO_THROW(check_feature_edges(mesh, edges));
}

}  // namespace
}  // namespace anisoquad
