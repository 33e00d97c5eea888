#include "smoothing/flat_star.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/face_middle.h"
#include "quad_grid.h"

namespace anisoquad {
namespace {

/// What the derivatives are of, by the star in space.
double worth(const Star& star, const Point& p) {
    const Star::Quality q = star.quality(p);
    return q.sines - Star::kStretchWeight * q.stretch;
}

void expect_alike(const Star::Quality& in_plane, const Star::Quality& in_space, double step) {
    EXPECT_NEAR(in_plane.worst, in_space.worst, 1e-9) << step;
    EXPECT_NEAR(in_plane.worst_changing, in_space.worst_changing, 1e-9) << step;
    EXPECT_NEAR(in_plane.mean, in_space.mean, 1e-9) << step;
    EXPECT_NEAR(in_plane.sines, in_space.sines, 1e-9) << step;
    EXPECT_NEAR(in_plane.lack, in_space.lack, 1e-9) << step;
    EXPECT_NEAR(in_plane.stretch, in_space.stretch, 1e-9) << step;
    EXPECT_NEAR(in_plane.ratio, in_space.ratio, 1e-9) << step;
}

TEST(FlatStar, DerivativesAreThoseOfTheStarInSpace) {
    for (const double stretch : {1.0, 3.0}) {
        const quad_grid::Grid grid = quad_grid::make(4, 4, [&](double x, double y) {
            const double u = x + 0.07 * std::sin(7.0 * x + 3.0 * y);  // no two edges alike: the longest has no rival
            const double v = stretch * (y + 0.05 * std::cos(4.0 * x * x + 9.0 * y));
            return Point(u, v, 0.3 * u + 0.2 * v);
        });
        const SurfaceMesh mesh = grid.mesh();
        const Vertex v = grid.vertex(2, 2);
        Star star;
        ASSERT_TRUE(star.gather(mesh, v));
        ASSERT_TRUE(star.is_flat());
        FlatStar flat;
        ASSERT_TRUE(flat.gather(mesh, v));
        ASSERT_TRUE(flat.has_quads_only());
        EXPECT_LT((flat.normal() - star.normal()).norm(), 1e-12);
        EXPECT_NEAR(flat.edge_length(), star.edge_length(), 1e-12);
        EXPECT_LT((flat(Eigen::Vector2d::Zero()) - mesh.position(v)).norm(), 1e-15);
        const FlatStar::Expansion d = flat.expand();
        const double h = 1e-4 * star.edge_length();
        const auto at = [&](double x, double y) { return worth(star, flat(Eigen::Vector2d(x * h, y * h))); };
        const double size = d.hessian.norm();
        EXPECT_NEAR(d.gradient.x(), (at(1, 0) - at(-1, 0)) / (2.0 * h), 1e-6 * size);
        EXPECT_NEAR(d.gradient.y(), (at(0, 1) - at(0, -1)) / (2.0 * h), 1e-6 * size);
        EXPECT_NEAR(d.hessian(0, 0), (at(1, 0) + at(-1, 0) - 2.0 * at(0, 0)) / (h * h), 1e-4 * size);
        EXPECT_NEAR(d.hessian(1, 1), (at(0, 1) + at(0, -1) - 2.0 * at(0, 0)) / (h * h), 1e-4 * size);
        EXPECT_NEAR(d.hessian(0, 1), (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * h * h), 1e-4 * size);
        EXPECT_NEAR(d.hessian(0, 1), d.hessian(1, 0), 1e-12 * size);
    }
}

TEST(FlatStar, QualityIsThatOfTheStarInSpace) {
    const quad_grid::Grid grid = quad_grid::make(4, 4, [](double x, double y) {
        const double u = x + 0.07 * std::sin(7.0 * x + 3.0 * y);
        const double v = 2.0 * y + 0.05 * std::cos(4.0 * x * x + 9.0 * y);
        return Point(u, v, 0.3 * u + 0.2 * v);
    });
    Star star;
    ASSERT_TRUE(star.gather(grid.mesh(), grid.vertex(2, 2)));
    FlatStar flat;
    ASSERT_TRUE(flat.gather(grid.mesh(), grid.vertex(2, 2)));
    expect_alike(flat.expand().quality, star.quality(star.centre()), 0.0);
    // Where it was, moved a little, onto an edge's line, and so far that faces are turned over.
    for (const double step : {0.0, 0.2, 0.9, 2.5}) {
        const Eigen::Vector2d x = step * star.edge_length() * Eigen::Vector2d(0.8, -0.6);
        EXPECT_LT((flat.coordinates(flat(x)) - x).norm(), 1e-12);
        const Star::Quality in_space = star.quality(flat(x));
        const Star::Quality in_plane = flat.quality(x);
        expect_alike(in_plane, in_space, step);
    }
}

TEST(FlatStar, TrianglesCountAsInSpace) {
    // Three quads and two triangles round the node.
    const quad_grid::Grid grid = quad_grid::make(4, 4, [](double x, double y) {
        const double u = x + 0.06 * std::sin(7.0 * x + 3.0 * y);
        return Point(u, y, 0.3 * u + 0.2 * y);
    });
    SurfaceMesh mesh = grid.mesh();
    const Vertex v = grid.vertex(2, 2);
    const Face face = mesh.face(mesh.halfedge(v));
    split_face(mesh, face, face_middle(mesh, face));
    Star star;
    ASSERT_TRUE(star.gather(mesh, v));
    FlatStar flat;
    ASSERT_TRUE(flat.gather(mesh, v));
    EXPECT_FALSE(flat.has_quads_only());
    for (const double step : {0.0, 0.3, 2.5}) {
        const Eigen::Vector2d x = step * star.edge_length() * Eigen::Vector2d(0.8, -0.6);
        expect_alike(flat.quality(x), star.quality(flat(x)), step);
    }
}

TEST(FlatStar, ABentStarIsNone) {
    for (const double bend : {0.05, 0.5}) {
        const quad_grid::Grid grid =
            quad_grid::make(4, 4, [&](double x, double y) { return Point(x, y, bend * std::abs(x - 0.5)); });
        FlatStar flat;
        EXPECT_EQ(flat.gather(grid.mesh(), grid.vertex(2, 2)), bend < 0.1);
    }
}

TEST(FlatStar, OfEqualEdgesRoundingChoosesNone) {
    // Parallelograms, twice: as they are, and with a node off by less than counts.
    for (const double off : {0.0, 1e-13, -1e-13}) {
        const quad_grid::Grid grid =
            quad_grid::make(4, 4, [&](double x, double y) { return Point(x + 0.4 * y + (x == 0.75 ? off : 0.0), 1.5 * y, 0.0); });
        FlatStar flat;
        ASSERT_TRUE(flat.gather(grid.mesh(), grid.vertex(2, 2)));
        EXPECT_LT(flat.expand().gradient.norm(), 1e-9) << off;
    }
}

TEST(FlatStar, AGridIsAtRest) {
    const quad_grid::Grid grid = quad_grid::make(4, 4, [](double x, double y) { return Point(x, y, 0.0); });
    FlatStar star;
    ASSERT_TRUE(star.gather(grid.mesh(), grid.vertex(2, 2)));
    const FlatStar::Expansion d = star.expand();
    EXPECT_LT(d.gradient.norm(), 1e-12);
    EXPECT_LT(d.hessian(0, 0), 0.0);
    EXPECT_GT(d.hessian.determinant(), 0.0);
}

}  // namespace
}  // namespace anisoquad
