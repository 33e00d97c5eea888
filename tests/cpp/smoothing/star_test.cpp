#include "smoothing/star.h"

#include <gtest/gtest.h>

#include "quad_grid.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

TEST(Star, CountsQuadsThatAreNotConvex) {
    const Grid g = make(2, 2, on_plane);
    const SurfaceMesh mesh = g.mesh();
    Star star;
    ASSERT_TRUE(star.gather(mesh, g.vertex(1, 1)));
    EXPECT_EQ(star.crossed(star.centre()), 0);
    // Past the middle of one quad's diagonal only that quad is dented; outside of it all but none is whole.
    EXPECT_EQ(star.crossed(Point(0.9, 0.9, 0.0)), 1);
    EXPECT_GE(star.crossed(Point(1.4, 0.5, 0.0)), 2);
}

TEST(Star, AQuadSeenFromBehindIsNotCrossed) {
    const Grid g = make(2, 2, on_plane);
    const SurfaceMesh mesh = g.mesh();
    Star star;
    ASSERT_TRUE(star.gather(mesh, g.vertex(1, 1)));
    star.see_along(-Eigen::Vector3d::UnitZ());
    EXPECT_LE(star.quality(star.centre()).worst, 0.0);
    EXPECT_EQ(star.crossed(star.centre()), 0);
}

}  // namespace
}  // namespace anisoquad
