#include "quality/distance.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "shapes.h"

namespace anisoquad {
namespace {

TEST(Distance, OfASurfaceFromItselfIsZero) {
    for (const shapes::Shape& shape : {shapes::cube(3), shapes::torus(20, 10), shapes::grid(4, 3)}) {
        const ReferenceSurface surface(shape.points, shape.triangles);
        EXPECT_NEAR(distance_to(surface, shape.mesh()) / surface.diagonal(), 0.0, 1e-14);
    }
}

TEST(Distance, IsSeenAtNodesEdgesAndFaces) {
    const shapes::Shape flat = shapes::grid(4, 4);
    const ReferenceSurface plane(flat.points, flat.triangles);
    SurfaceMesh raised = flat.mesh();
    raised.position(Vertex(12)).z() = 0.25;
    EXPECT_NEAR(distance_to(plane, raised), 0.25, 1e-14);

    // The other way the coarse surface has no node there: the middle of its diagonal is what is farthest from the peak's sides.
    shapes::Shape peak = shapes::grid(2, 2);
    peak.points[4].z() = 0.5;
    const ReferenceSurface tent(peak.points, peak.triangles);
    const shapes::Shape coarse = shapes::grid(1, 1, 2.0, 2.0);
    const double seen = distance_to(tent, coarse.mesh());
    EXPECT_GT(seen, 0.3);
    EXPECT_LE(seen, 0.5);
}

TEST(Distance, AQuadCountsAsItsTwoHalves) {
    shapes::Shape shape = shapes::grid(1, 1);
    shape.points[3].z() = 1.0;
    SurfaceMesh mesh = shape.mesh();
    const HalfEdge diagonal = mesh.find_halfedge(Vertex(0), Vertex(3));
    const ReferenceSurface surface(shape.points, shape.triangles);
    const Face quad = dissolve_edge(mesh, SurfaceMesh::edge(diagonal));
    HalfEdge h = mesh.halfedge(quad);
    for (int k = 0; k < 4; ++k, h = mesh.next(h)) {
        mesh.set_halfedge(quad, h);
        const bool same_diagonal = mesh.from(h) == Vertex(0) || mesh.from(h) == Vertex(3);
        EXPECT_EQ(distance_to(surface, mesh) < 1e-12, same_diagonal);
    }
}

}  // namespace
}  // namespace anisoquad
