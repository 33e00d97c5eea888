#include "surface/surface_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/arrays.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

/// A surface as a height over the xy plane that touches it at the origin.
using Height = std::function<double(double, double)>;

const Height kPlane = [](double, double) { return 0.0; };
const Height kSphere = [](double x, double y) { return 1.0 - std::sqrt(1.0 - x * x - y * y); };
const Height kCylinder = [](double x, double) { return 1.0 - std::sqrt(1.0 - x * x); };
const Height kSaddle = [](double x, double y) { return 0.5 * (x * x - y * y) + 0.1 * x * x * x; };

/// Ring of n nodes on the surface, unevenly spread, of mean radius h.
std::vector<Point> ring_on(const Height& surface, int n, double h, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-1.0, 1.0);
    std::vector<Point> ring;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.15 * jitter(random)) / n;
        const double r = h * (1.0 + 0.15 * jitter(random));
        const double x = r * std::cos(angle);
        const double y = r * std::sin(angle);
        ring.emplace_back(x, y, surface(x, y));
    }
    return ring;
}

/// Largest distance from the surface (along z) of the fit at half the ring's radius, over the radius.
double position_error(const Height& surface, int n, double h) {
    SurfaceFit fit;
    EXPECT_TRUE(fit_surface(Point::Zero(), ring_on(surface, n, h), true, fit)) << n << " nodes";
    double error = 0.0;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 12.0;
        const Point p = fit(0.5 * h * std::cos(angle), 0.5 * h * std::sin(angle));
        error = std::max(error, std::abs(p.z() - surface(p.x(), p.y())));
    }
    return error / h;
}

/// Gaussian and mean curvature from the fit's derivatives @cite docarmo1976.
std::pair<double, double> curvatures(const SurfaceFit& fit) {
    const Vector3d u = fit.derivative_u(0, 0);
    const Vector3d v = fit.derivative_v(0, 0);
    const Vector3d n = fit.normal(0, 0);
    const double e = u.dot(u), f = u.dot(v), g = v.dot(v);
    const double l = n.dot(fit.second_derivative_uu()), m = n.dot(fit.second_derivative_uv()),
                 k = n.dot(fit.second_derivative_vv());
    const double determinant = e * g - f * f;
    return {(l * k - m * m) / determinant, 0.5 * (e * k - 2.0 * f * m + g * l) / determinant};
}

class SurfaceFitRing : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Neighbours, SurfaceFitRing, testing::Values(3, 4, 5, 6, 8));

TEST_P(SurfaceFitRing, PlaneIsReproduced) { EXPECT_LT(position_error(kPlane, GetParam(), 1.0), 1e-12); }

TEST_P(SurfaceFitRing, RunsThroughTheNodeAndNearTheRing) {
    for (const Height& surface : {kSphere, kCylinder, kSaddle}) {
        const std::vector<Point> ring = ring_on(surface, GetParam(), 0.2);
        SurfaceFit fit;
        ASSERT_TRUE(fit_surface(Point::Zero(), ring, true, fit));
        EXPECT_EQ(fit(0, 0), Point::Zero());
        ASSERT_EQ(fit.size(), GetParam());
        for (int i = 0; i < fit.size(); ++i) {
            const Point p = fit(fit.parameters(i).x(), fit.parameters(i).y());
            const double bound = GetParam() <= 5 ? 1e-10 : 0.02;  // up to five nodes are met exactly
            EXPECT_LT((p - ring[static_cast<std::size_t>(i)]).norm(), bound * 0.2);
        }
        EXPECT_GT(fit.normal(0, 0).z(), 0.9);
    }
}

TEST_P(SurfaceFitRing, PositionErrorShrinksUnderRefinement) {
    for (const Height& surface : {kSphere, kCylinder, kSaddle}) {
        const double coarse = position_error(surface, GetParam(), 0.2);
        const double fine = position_error(surface, GetParam(), 0.05);
        // A relative error of first order (curvature unresolved) for three nodes, of second order from five on.
        const double order = std::log(coarse / fine) / std::log(4.0);
        EXPECT_GT(order, GetParam() < 5 ? 0.9 : 1.7) << coarse << " → " << fine;
        EXPECT_LT(fine, GetParam() < 5 ? 0.02 : 1e-3);
    }
}

TEST(SurfaceFit, CurvatureConvergesFromFiveNodesOn) {
    for (const int n : {5, 6, 8}) {
        double last = std::numeric_limits<double>::infinity();
        for (const double h : {0.2, 0.1, 0.05}) {
            SurfaceFit fit;
            ASSERT_TRUE(fit_surface(Point::Zero(), ring_on(kSphere, n, h), true, fit));
            const auto [gauss, mean] = curvatures(fit);
            const double error = std::abs(gauss - 1.0) + std::abs(mean - 1.0);
            EXPECT_LT(error, 5.0 * h) << n << " nodes";
            EXPECT_LT(error, 0.65 * last) << n << " nodes";
            last = error;
        }
    }
}

TEST(SurfaceFit, StretchedRingsStayWellConditioned) {
    for (const double aspect : {5.0, 20.0, 50.0}) {
        for (const int n : {4, 5, 6, 8}) {
            // Long along the axis of the cylinder, short round it.
            std::vector<Point> ring;
            for (Point p : ring_on(kPlane, n, 0.02)) {
                p.y() *= aspect;
                ring.emplace_back(p.x(), p.y(), kCylinder(p.x(), p.y()));
            }
            SurfaceFit fit;
            ASSERT_TRUE(fit_surface(Point::Zero(), ring, true, fit)) << "1:" << aspect << ", " << n << " nodes";
            for (const Point& target : {Point(0.005, 0.005 * aspect, 0), Point(-0.008, 0, 0), Point(0, -0.01 * aspect, 0)}) {
                const Point p = point_at_target(fit, target);
                EXPECT_NEAR(p.z(), kCylinder(p.x(), p.y()), 0.02 * 0.02) << "1:" << aspect << ", " << n << " nodes";
                EXPECT_LT((p - target).norm(), 0.02 * 0.1);
            }
        }
    }
}

TEST(SurfaceFit, DegenerateRingsFail) {
    SurfaceFit fit;
    const Point o = Point::Zero();
    const std::vector<Point> line{{1, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {-3, 0, 0}};
    EXPECT_FALSE(fit_surface(o, line, true, fit));
    const std::vector<Point> twice{{1, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    EXPECT_FALSE(fit_surface(o, twice, true, fit));
    const std::vector<Point> on_centre{{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    EXPECT_FALSE(fit_surface(o, on_centre, true, fit));
    const std::vector<Point> few{{1, 0, 0}, {0, 1, 0}};
    EXPECT_FALSE(fit_surface(o, few, true, fit));
    const std::vector<Point> bad{{1, 0, 0}, {0, 1, 0}, {-1, std::nan(""), 0}, {0, -1, 0}};
    EXPECT_FALSE(fit_surface(o, bad, true, fit));
    EXPECT_FALSE(fit_surface(o, {}, true, fit));
}

TEST(SurfaceFit, OpenRingKeepsItsAngles) {
    const std::vector<Point> half{{1, 0, 0}, {1, 1, 0}, {0, 1.3, 0}, {-1, 1, 0}, {-1, 0, 0}};
    SurfaceFit fit;
    ASSERT_TRUE(fit_surface(Point::Zero(), half, false, fit));
    for (int i = 0; i < 5; ++i) EXPECT_LT((fit.parameters(i) - half[static_cast<std::size_t>(i)].head<2>()).norm(), 1e-12);
}

TEST(SurfaceFit, LargeRingsAreThinnedOut) {
    SurfaceFit fit;
    ASSERT_TRUE(fit_surface(Point::Zero(), ring_on(kSphere, 100, 0.1), true, fit));
    EXPECT_EQ(fit.size(), SurfaceFit::kCapacity);
    const Point p = point_at_target(fit, {0.05, 0.02, 0.0});
    EXPECT_NEAR(p.z(), kSphere(p.x(), p.y()), 1e-4);
}

TEST(SurfaceFit, ScaleTranslationAndRotationDontMatter) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (const int n : {3, 4, 5, 7}) {
        const std::vector<Point> ring = ring_on(kSaddle, n, 0.2);
        SurfaceFit fit;
        ASSERT_TRUE(fit_surface(Point::Zero(), ring, true, fit));
        const Point target(0.05, 0.07, 0.0);
        const Point expected = point_at_target(fit, target);
        for (const auto& [scale, offset] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e3)}) {
            const Vector3d shift(offset, -offset, 2.0 * offset);
            std::vector<Point> moved;
            for (const Point& p : ring) moved.push_back(scale * (turn * p) + shift);
            SurfaceFit other;
            ASSERT_TRUE(fit_surface(shift, moved, true, other));
            const Point p = point_at_target(other, scale * (turn * target) + shift);
            EXPECT_LT((turn.transpose() * (p - shift) / scale - expected).norm(), 1e-9);
        }
    }
}

TEST(SurfaceFit, TargetsBeyondTheRingAreHeldBack) {
    SurfaceFit fit;
    ASSERT_TRUE(fit_surface(Point::Zero(), ring_on(kSphere, 6, 0.2), true, fit));
    EXPECT_LT(point_at_target(fit, {100.0, 50.0, 3.0}).norm(), 0.35);
}

TEST(SurfaceFit, RingOfTheMeshRunsCounterClockwise) {
    // Two by two squares, each of two triangles: one interior node.
    std::vector<Point> points;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) points.emplace_back(i, j, 0);
    }
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            const int a = 3 * j + i;
            triangles.push_back({a, a + 1, a + 4});
            triangles.push_back({a, a + 4, a + 3});
        }
    }
    const SurfaceMesh mesh = from_arrays(points, triangles);
    SurfaceFit fit;
    ASSERT_TRUE(fit_surface(mesh, Vertex(4), fit));
    EXPECT_GT(fit.normal(0, 0).z(), 0.99);
    // A node on the straight lower boundary: the ring starts and ends on the boundary.
    std::array<Point, 8> ring;
    const int n = gather_ring(mesh, Vertex(1), ring);
    ASSERT_EQ(n, 4);
    EXPECT_EQ(ring[0], points[2]);
    EXPECT_EQ(ring[3], points[0]);
}

}  // namespace
}  // namespace anisoquad
