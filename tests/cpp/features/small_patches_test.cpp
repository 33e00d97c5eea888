#include "features/small_patches.h"

#include <gtest/gtest.h>

#include "features/parity.h"
#include "mesh/validate.h"
#include "quad_mesh.h"
#include "shapes.h"
#include "stages.h"

namespace anisoquad {
namespace {

using shapes::Shape;

Shape triangle(const Point& apex) {
    Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, apex};
    shape.triangles = {{0, 1, 2}};
    return shape;
}

TEST(SmallPatches, ASingleTriangleIsFilledWithGoodQuads) {
    for (const Point& apex : {Point(0.5, 0.8, 0.0), Point(0.0, 1.0, 0.0), Point(0.9, 0.3, 1.0)}) {
        const Shape shape = triangle(apex);
        const QuadMeshResult result = quad_mesh(shape.points, shape.triangles);
        EXPECT_EQ(result.quads.size(), 3u);
        EXPECT_EQ(result.report.triangles_left, 0);
        EXPECT_GT(result.report.scaled_jacobian.min, 0.25);
    }
}

TEST(SmallPatches, TrianglesThatShareAFeatureEdgeAreAllOpened) {
    // Two triangles with a ridge between them, each a patch of its own.
    Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0.4}, {0.5, -0.8, 0.4}};
    shape.triangles = {{0, 1, 2}, {1, 0, 3}};
    SurfaceMesh mesh = shape.mesh();
    find_features(mesh, {}, {});
    ASSERT_EQ(find_patches(mesh), 2);
    EXPECT_EQ(refine_small_patches(mesh), 5);
    EXPECT_EQ(stages::triangle_count(mesh), 0);
    EXPECT_EQ(stages::quad_count(mesh), 6);
    EXPECT_TRUE(validate(mesh).empty());
    const QuadMeshResult result = quad_mesh(shape.points, shape.triangles);
    EXPECT_EQ(result.quads.size(), 6u);
    EXPECT_GT(result.report.scaled_jacobian.min, 0.2);
}

TEST(SmallPatches, TwoTrianglesThatMakeNoConvexQuadBecomeSix) {
    Shape dart;
    dart.points = {{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
    dart.triangles = {{0, 1, 2}, {0, 2, 3}};
    const QuadMeshResult result = quad_mesh(dart.points, dart.triangles);
    EXPECT_EQ(result.quads.size(), 6u);
    EXPECT_EQ(result.report.inverted, 0);
    Shape square = dart;
    square.points[2] = {4, 0, 0};
    EXPECT_EQ(quad_mesh(square.points, square.triangles).quads.size(), 1u);
}

TEST(SmallPatches, ATetrahedronWithoutFeatureLinesBecomesTwelveQuads) {
    Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0.0}, {0.5, 0.3, 0.9}};
    shape.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    Options options;
    options.feature_angle = 180.0;
    options.prepare = false;
    options.validate = true;
    const QuadMeshResult result = quad_mesh(shape.points, shape.triangles, {}, options);
    EXPECT_EQ(result.report.triangles_left, 0);
    EXPECT_EQ(result.quads.size(), 12u);
}

TEST(SmallPatches, LargerPatchesStay) {
    for (const Shape& shape : {shapes::grid(3, 3), shapes::cube(2), shapes::torus(9, 5)}) {
        SurfaceMesh mesh = shape.mesh();
        find_features(mesh, {}, {});
        EXPECT_EQ(refine_small_patches(mesh), 0);
    }
}

}  // namespace
}  // namespace anisoquad
