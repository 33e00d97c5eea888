#include "smoothing/line_smoothing.h"

#include <gtest/gtest.h>

#include "quad_grid.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

TEST(LineSmoothing, SlidesOnAStraightBoundary) {
    const Grid g = make(4, 4, on_plane);
    SurfaceMesh mesh = g.mesh();
    const Vertex v = g.vertex(2, 0);
    mesh.position(v).x() = 0.62;
    for (int i = 0; i < 3; ++i) slide_on_line(mesh, v);
    EXPECT_EQ(mesh.position(v).y(), 0.0);
    EXPECT_NEAR(mesh.position(v).x(), 0.5, 0.02);
    EXPECT_EQ(mesh.info(v).input, -1);
}

TEST(LineSmoothing, LeavesBentLinesCornersAndRowsAlone) {
    const Grid g = make(8, 4, on_cylinder);
    SurfaceMesh mesh = g.mesh();
    mesh.position(g.vertex(3, 1)) = on_cylinder(0.45, 0.3);
    EXPECT_FALSE(slide_on_line(mesh, g.vertex(3, 0))) << "the boundary is an arc";
    EXPECT_FALSE(slide_on_line(mesh, g.vertex(0, 0))) << "corner";
    EXPECT_FALSE(slide_on_line(mesh, g.vertex(3, 2))) << "interior";
    mesh.position(g.vertex(0, 2)) = on_cylinder(0.0, 0.6);
    mesh.info(g.vertex(0, 2)).in_row = true;
    EXPECT_FALSE(slide_on_line(mesh, g.vertex(0, 2))) << "in a row";
    mesh.info(g.vertex(0, 2)).in_row = false;
    EXPECT_TRUE(slide_on_line(mesh, g.vertex(0, 2))) << "straight";
    EXPECT_GT(mesh.position(g.vertex(0, 2)).y(), mesh.position(g.vertex(0, 1)).y());
    EXPECT_LT(mesh.position(g.vertex(0, 2)).y(), mesh.position(g.vertex(0, 3)).y());
}

TEST(LineSmoothing, NoPoorElementBecomesPoorer) {
    const Grid g = make(12, 4, on_plane);
    int moved = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        SurfaceMesh mesh = g.mesh();
        distort(mesh, g, on_plane, 0.6, seed);
        for (int i = 1; i < 12; ++i) {
            Star star;
            ASSERT_TRUE(star.gather(mesh, g.vertex(i, 0)));
            star.use_face_normals();
            const double before = star.quality(star.centre()).worst;
            moved += slide_on_line(mesh, g.vertex(i, 0)) ? 1 : 0;
            EXPECT_GE(star.quality(mesh.position(g.vertex(i, 0))).worst, std::min(before, Star::kPoor)) << seed << ", " << i;
        }
    }
    EXPECT_GT(moved, 100);
}

}  // namespace
}  // namespace anisoquad
