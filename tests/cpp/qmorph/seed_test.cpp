#include "qmorph/seed.h"

#include <gtest/gtest.h>

#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

/// Quality of the quad that the two triangles beside the edge make.
double pair_quality(const SurfaceMesh& mesh, Edge e) {
    const HalfEdge h = M::halfedge(e);
    const HalfEdge g = M::twin(h);
    const auto at = [&](Vertex v) -> const Point& { return mesh.position(v); };
    return scaled_jacobian(at(mesh.from(h)), at(mesh.to(mesh.next(g))), at(mesh.to(h)), at(mesh.to(mesh.next(h))));
}

TEST(Seed, AClosedSurfaceStartsFromItsBestPair) {
    for (const auto& shape : {shapes::sphere(18, 11), shapes::torus(20, 12)}) {
        Prepared p(shape);
        double best = -1.0;
        for (const Edge e : edges(p.mesh)) best = std::max(best, pair_quality(p.mesh, e));
        EXPECT_EQ(start_closed_components(p.mesh), 1);
        EXPECT_EQ(quad_count(p.mesh), 1);
        for (const Face f : faces(p.mesh)) {
            if (!p.mesh.is_quad(f)) continue;
            EXPECT_NEAR(scaled_jacobian(p.mesh, f), best, 1e-12);
            EXPECT_EQ(p.mesh.info(f).patch, 0);
            EXPECT_TRUE(is_front(p.mesh, M::twin(p.mesh.halfedge(f))));
        }
        expect_sound(p);
    }
}

TEST(Seed, EveryClosedComponentGetsOne) {
    Prepared p(shapes::joined(shapes::sphere(14, 9),
                              shapes::joined(shapes::placed(shapes::torus(20, 12), 1.0, Point(9, 0, 0)), shapes::grid(3, 3))));
    EXPECT_EQ(start_closed_components(p.mesh), 2);
    EXPECT_EQ(quad_count(p.mesh), 2);
    expect_sound(p);
}

TEST(Seed, AFrontIsStartEnough) {
    Prepared plane(shapes::grid(4, 4));
    EXPECT_EQ(start_closed_components(plane.mesh), 0);
    Prepared cube(shapes::cube(3));
    EXPECT_EQ(start_closed_components(cube.mesh), 0);
    Prepared line(shapes::torus(20, 12), {source({3, 4, 5})});
    EXPECT_EQ(start_closed_components(line.mesh), 0);
    EXPECT_EQ(quad_count(line.mesh), 0);
}

}  // namespace
}  // namespace anisoquad
