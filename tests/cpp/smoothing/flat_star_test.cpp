#include "smoothing/flat_star.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quad_grid.h"

namespace anisoquad {
namespace {

TEST(FlatStar, ScoresAsTheStarInSpaceDoes) {
    const quad_grid::Grid grid =
        quad_grid::make(4, 4, [](double x, double y) { return Point(x + 0.1 * std::sin(5.0 * y), y + 0.1 * x * x, 0.3 * (x + 0.1 * std::sin(5.0 * y)) + 0.2 * (y + 0.1 * x * x)); });
    const SurfaceMesh mesh = grid.mesh();
    const Vertex v = grid.vertex(2, 2);
    Star star;
    ASSERT_TRUE(star.gather(mesh, v));
    ASSERT_TRUE(star.is_flat());
    ASSERT_TRUE(star.has_quads_only());
    const FlatStar flat(star);
    EXPECT_LT((flat.at(Eigen::Vector2d::Zero()) - mesh.position(v)).norm(), 1e-15);
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
            const Eigen::Vector2d x = 0.15 * star.edge_length() * Eigen::Vector2d(i, j);
            EXPECT_NEAR(flat.score(x), star.quality(flat.at(x)).score(), 1e-12);
        }
    }
}

}  // namespace
}  // namespace anisoquad
