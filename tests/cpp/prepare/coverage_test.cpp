#include "prepare/coverage.h"

#include <gtest/gtest.h>

#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "prepare/collapse_check.h"

namespace anisoquad {
namespace {

/// Four triangles round a node in the middle of a square of side 2, the node lifted by `height`.
SurfaceMesh pyramid(double height) {
    const std::vector<Point> points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, height}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    return from_arrays(points, triangles);
}

TEST(Coverage, AnUncoveredTipIsNoticed) {
    SurfaceMesh mesh = pyramid(0.5);
    Coverage coverage(mesh, 1.0, 0.1);
    coverage.lift(mesh, Vertex(4));
    const std::vector<Coverage::Triangle> flat{{mesh.position(Vertex(0)), mesh.position(Vertex(1)), mesh.position(Vertex(2))},
                                               {mesh.position(Vertex(0)), mesh.position(Vertex(2)), mesh.position(Vertex(3))}};
    EXPECT_FALSE(coverage.is_covered_by(flat));
    coverage.drop(mesh, Vertex(4));
    Coverage loose(mesh, 1.0, 0.6);
    loose.lift(mesh, Vertex(4));
    EXPECT_TRUE(loose.is_covered_by(flat));
}

TEST(Coverage, PointsFollowTheTrianglesThatReplaceTheirs) {
    SurfaceMesh mesh = pyramid(0.05);
    Coverage coverage(mesh, 1.0, 0.1);
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const std::vector<Point> points{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0.05}};
    const ReferenceSurface reference(points, triangles);
    for (std::int32_t i = 0; i < 5; ++i) mesh.info(Vertex(i)).size = 2.0;
    const HalfEdge h = mesh.find_halfedge(Vertex(4), Vertex(0));
    ASSERT_TRUE(try_collapse(mesh, h, reference, 0.1, &coverage));
    EXPECT_EQ(mesh.face_count(), 2);
    // The points are all at the corner's triangles now: a triangle far away does not cover them, their own do.
    coverage.lift(mesh, Vertex(0));
    const std::vector<Coverage::Triangle> far{{Point(9, 9, 9), Point(10, 9, 9), Point(9, 10, 9)}};
    EXPECT_FALSE(coverage.is_covered_by(far));
    coverage.drop(mesh, Vertex(0));
}

}  // namespace
}  // namespace anisoquad
