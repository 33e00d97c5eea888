#include "surface/reference_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace anisoquad {
namespace {

using Eigen::Vector3d;
using Triangles = std::vector<std::array<std::int32_t, 3>>;

struct Surface {
    std::vector<Point> points;
    Triangles triangles;
    std::vector<std::int32_t> patch;
};

/// n × n squares of two triangles over [0,1]², mapped; every square's patch from its column.
template <class Map, class Patch>
Surface grid(int n, Map map, Patch patch) {
    Surface s;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) s.points.push_back(map(double(i) / n, double(j) / n));
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            s.triangles.push_back({a, a + 1, a + n + 2});
            s.triangles.push_back({a, a + n + 2, a + n + 1});
            s.patch.insert(s.patch.end(), 2, patch(i));
        }
    }
    return s;
}

Point on_cylinder(double x, double y) { return {std::cos(2.0 * x), 2.0 * y, std::sin(2.0 * x)}; }

/// Distance to a triangle by the projections on its plane, edges and corners.
double distance_to_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
    const Vector3d n = (b - a).cross(c - a);
    const std::array<Point, 3> corner{a, b, c};
    const Point foot = p - (p - a).dot(n) / n.squaredNorm() * n;
    bool inside = true;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Point& q = corner[k];
        const Vector3d e = corner[(k + 1) % 3] - q;
        inside = inside && e.cross(foot - q).dot(n) >= 0.0;
        const double t = std::clamp((p - q).dot(e) / e.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (q + t * e - p).norm());
    }
    return inside ? (foot - p).norm() : best;
}

TEST(ReferenceSurface, AgreesWithBruteForce) {
    const Surface s = grid(12, on_cylinder, [](int i) { return i / 4; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.5, 2.5);
    for (int k = 0; k < 500; ++k) {
        const Point p(unit(random), unit(random), unit(random));
        for (const std::int32_t patch : {ReferenceSurface::kAnyPatch, 0, 1, 2}) {
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t f = 0; f < s.triangles.size(); ++f) {
                if (patch >= 0 && s.patch[f] != patch) continue;
                const auto& t = s.triangles[f];
                best = std::min(best, distance_to_triangle(p, s.points[std::size_t(t[0])], s.points[std::size_t(t[1])],
                                                           s.points[std::size_t(t[2])]));
            }
            const SurfacePoint found = reference.closest(p, patch);
            EXPECT_NEAR(found.distance, best, 1e-12);
            EXPECT_NEAR((found.position - p).norm(), found.distance, 1e-12);
            EXPECT_TRUE(patch < 0 || reference.facet_patch(found.facet) == patch);
        }
    }
}

TEST(ReferenceSurface, HintsDontChangeTheResult) {
    const Surface s = grid(16, on_cylinder, [](int i) { return i / 8; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 300; ++k) {
        // Corners, edges and inner points of the facets, so that many facets are equally close.
        const double x = std::round(16.0 * unit(random)) / 16.0;
        const double y = k % 3 == 0 ? unit(random) : std::round(16.0 * unit(random)) / 16.0;
        const Point p = (k % 2 == 0 ? 1.0 : 1.05) * on_cylinder(x, y);
        const SurfacePoint expected = reference.closest(p, k % 5 == 0 ? 1 : -1);
        for (const std::int32_t hint : {-1, 0, 100, 511, 99999}) {
            const SurfacePoint found = reference.closest(p, k % 5 == 0 ? 1 : -1, hint);
            EXPECT_EQ(found.facet, expected.facet);
            EXPECT_EQ(found.position, expected.position);
        }
    }
}

/// The skin of a wing of the given thickness, unrolled: one patch goes round its leading edge at x = 1 from the lower sheet to
/// the upper one.
ReferenceSurface thin_skin(double thickness) {
    const Surface s = grid(
        20,
        [=](double x, double y) {
            const double way = 2.0 * x;
            return way <= 1.0 ? Point(1.0 - way, y, 0.0) : Point(way - 1.0, y, thickness * std::min(1.0, 20.0 * (way - 1.0)));
        },
        [](int) { return 0; });
    return {s.points, s.triangles, s.patch};
}

TEST(ReferenceSurface, OfTwoSheetsThatLieCloseTheOneThatIsMeantIsFound) {
    const ReferenceSurface skin = thin_skin(1e-3);
    const Vector3d up(0.0, 0.0, 3.0);   // of any length
    const Point p(0.63, 0.41, 0.4e-3);  // between the sheets, closer to the lower one, which faces down
    const double faces = skin.closest(p).normal.z();
    ASSERT_LT(skin.closest(p).distance, 0.41e-3);
    const SurfacePoint other = skin.closest(p, {0, -faces * up});
    EXPECT_NEAR(other.distance, 0.6e-3, 1e-12);
    EXPECT_NEAR(other.normal.z(), -faces, 1e-9);
    const SurfacePoint same = skin.closest(p, {0, faces * up});
    EXPECT_EQ(same.position, skin.closest(p).position);
    std::int32_t hint = skin.closest(p).facet;
    EXPECT_NEAR(skin.project(p, {0, -faces * up}, hint).z(), 1e-3, 1e-12);
    EXPECT_EQ(hint, other.facet);
    // Seen along the sheets neither faces away.
    EXPECT_EQ(skin.closest(p, {0, Vector3d::UnitX()}).position, skin.closest(p).position);
}

TEST(ReferenceSurface, ASheetThatIsFarIsNotMeant) {
    const ReferenceSurface thick = thin_skin(0.1);
    const Point p(0.63, 0.41, 0.02);
    const double faces = thick.closest(p).normal.z();
    EXPECT_EQ(thick.closest(p, {0, Vector3d(0.0, 0.0, -faces)}).position, thick.closest(p).position);
}

TEST(ReferenceSurface, EquallyCloseFacetsGiveTheLowestIndex) {
    const Surface s = grid(
        8, [](double x, double y) { return Point(x, y, 0); }, [](int) { return 0; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    EXPECT_EQ(reference.closest(Point(0.5, 0.5, 0.0)).facet, [&] {
        for (std::int32_t f = 0;; ++f) {
            for (std::int32_t v : s.triangles[std::size_t(f)]) {
                if (s.points[std::size_t(v)] == Point(0.5, 0.5, 0.0)) return f;
            }
        }
    }());
}

TEST(ReferenceSurface, EmptySurfaceAndMissingPatchGiveNoFacet) {
    const ReferenceSurface none;
    EXPECT_EQ(none.closest(Point::Zero()).facet, -1);
    const Surface s = grid(2, on_cylinder, [](int) { return 0; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    EXPECT_EQ(reference.closest(Point::Zero(), 5).facet, -1);
    std::int32_t hint = -1;
    EXPECT_EQ(reference.project(Point(1, 2, 3), 5, hint), Point(1, 2, 3));
}

TEST(ReferenceSurface, NormalsAreSplitAtFeatures) {
    // A roof: two planes at right angles meet in x = 0.5.
    const Surface s = grid(
        4, [](double x, double y) { return Point(x, y, x < 0.5 ? x : 1.0 - x); }, [](int i) { return i / 2; });
    const std::vector<std::int32_t> one(s.triangles.size(), 0);
    for (const auto& patch : {s.patch, one}) {  // by the patches, and by the crease alone
        const ReferenceSurface reference(s.points, s.triangles, patch, 40.0);
        const Vector3d left = reference.closest(Point(0.49, 0.5, 0.49)).normal;
        EXPECT_LT((left - Vector3d(-1, 0, 1).normalized()).norm(), 1e-12);
        std::int32_t hint = -1;
        const Point p(0.4, 0.3, 0.4);
        EXPECT_LT((reference.project(p, 0, hint) - p).norm(), 1e-12) << "flat facets must not be lifted";
    }
}

TEST(ReferenceSurface, ProjectionLiftsPointsTowardsTheCurvedSurface) {
    const Surface s = grid(10, on_cylinder, [](int) { return 0; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    double flat_error = 0.0;
    double lifted_error = 0.0;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(0.15, 0.85);
    std::int32_t hint = -1;
    for (int k = 0; k < 200; ++k) {
        const Point p = on_cylinder(inside(random), inside(random));
        const auto radius = [](const Point& q) { return std::hypot(q.x(), q.z()); };
        flat_error = std::max(flat_error, std::abs(radius(reference.closest(p).position) - 1.0));
        const Point lifted = reference.project(p, 0, hint);
        lifted_error = std::max(lifted_error, std::abs(radius(lifted) - 1.0));
        EXPECT_LE((lifted - reference.closest(p).position).norm(), 5.001e-4 * reference.diagonal());
    }
    EXPECT_LT(lifted_error, 0.8 * flat_error);
}

TEST(ReferenceSurface, SizeAndPlaceOfTheModelDontMatter) {
    const Surface s = grid(10, on_cylinder, [](int) { return 0; });
    const ReferenceSurface reference(s.points, s.triangles, s.patch);
    for (const auto& [scale, offset] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e3)}) {
        const Vector3d shift = Vector3d::Constant(offset);
        std::vector<Point> moved;
        for (const Point& p : s.points) moved.push_back(scale * p + shift);
        const ReferenceSurface other(moved, s.triangles, s.patch);
        for (const Point& p : {Point(0.9, 0.77, 0.31), Point(0.3, 1.11, 0.9)}) {
            std::int32_t a = -1;
            std::int32_t b = -1;
            const Point expected = reference.project(p, 0, a);
            const Point found = other.project(scale * p + shift, 0, b);
            EXPECT_EQ(a, b);
            EXPECT_LT(((found - shift) / scale - expected).norm(), 1e-9);
        }
    }
}

}  // namespace
}  // namespace anisoquad
