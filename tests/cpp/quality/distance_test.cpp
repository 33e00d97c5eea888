#include "quality/distance.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace anisoquad {
namespace {

TEST(Distance, OfASurfaceFromItselfIsZero) {
    for (const shapes::Shape& shape : {shapes::cube(3), shapes::torus(20, 10), shapes::grid(4, 3)}) {
        const FacetTree surface(shape.points, shape.triangles);
        EXPECT_NEAR(distance_to(surface, surface) / surface.diagonal(), 0.0, 1e-14);
    }
}

TEST(Distance, IsSeenAtNodesEdgesAndFaces) {
    const shapes::Shape flat = shapes::grid(4, 4);
    const FacetTree plane(flat.points, flat.triangles);
    shapes::Shape raised = flat;
    raised.points[12].z() = 0.25;
    EXPECT_NEAR(distance_to(plane, FacetTree(raised.points, raised.triangles)), 0.25, 1e-14);

    // The other way the coarse surface has no node there: the middle of its diagonal is what is farthest from the peak's sides.
    shapes::Shape peak = shapes::grid(2, 2);
    peak.points[4].z() = 0.5;
    const FacetTree tent(peak.points, peak.triangles);
    const shapes::Shape coarse = shapes::grid(1, 1, 2.0, 2.0);
    const double seen = distance_to(tent, FacetTree(coarse.points, coarse.triangles));
    EXPECT_GT(seen, 0.3);
    EXPECT_LE(seen, 0.5);
}

}  // namespace
}  // namespace anisoquad
