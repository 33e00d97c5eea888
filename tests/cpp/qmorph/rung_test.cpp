#include "qmorph/rung.h"

#include <gtest/gtest.h>

#include "qmorph/quad_formation.h"
#include "quad_mesh.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;
using M = SurfaceMesh;

/// A strip three wide, one cell across, with a quad at its lower end.
struct Strip : Prepared {
    Strip() : Prepared(shapes::grid(1, 3, 3.0, 1.0)) {
        quad = form_quad(mesh, mesh.find_halfedge(Vertex(0), Vertex(1)), Vertex(3), Vertex(2));
        for (const Vertex v : vertices(mesh)) mesh.info(v).size = 0.8;
    }
    HalfEdge rung() const { return mesh.find_halfedge(Vertex(2), Vertex(3)); }
    Face quad;
};

TEST(Rung, IsWideByTheSizesWantedAtItsEnds) {
    Strip strip;
    ASSERT_TRUE(strip.quad.is_valid());
    EXPECT_TRUE(is_wide_rung(strip.mesh, strip.rung()));
    for (const int v : {2, 3}) strip.mesh.info(Vertex(v)).size = 2.0;
    EXPECT_FALSE(is_wide_rung(strip.mesh, strip.rung()));
}

TEST(Rung, LeadsFromLineToLineOverAQuadOfNoRow) {
    Strip strip;
    const HalfEdge diagonal = strip.mesh.next(strip.rung());
    EXPECT_FALSE(is_wide_rung(strip.mesh, M::twin(diagonal)));
    strip.mesh.info(strip.quad).row = 1;
    EXPECT_FALSE(is_wide_rung(strip.mesh, strip.rung()));
    Prepared inside(shapes::grid(3, 3));
    form_quad(inside.mesh, inside.mesh.find_halfedge(Vertex(1), Vertex(2)), Vertex(6), Vertex(5));
    for (const Vertex v : vertices(inside.mesh)) inside.mesh.info(v).size = 0.1;
    EXPECT_FALSE(is_wide_rung(inside.mesh, inside.mesh.find_halfedge(Vertex(5), Vertex(6))));
}

TEST(Rung, IsCutInThreeAndItsQuadInFour) {
    Strip strip;
    const int triangles = triangle_count(strip.mesh);
    const Face middle = split_rung(strip.mesh, strip.rung(), &strip.reference);
    expect_sound(strip);
    EXPECT_EQ(quad_count(strip.mesh), 4);
    EXPECT_EQ(triangle_count(strip.mesh), triangles + 2);
    EXPECT_FALSE(strip.rung().is_valid());
    for (const Face f : faces(strip.mesh)) {
        EXPECT_GT(doubled_area(strip.mesh, f).z(), 0.0);
        EXPECT_LE(strip.mesh.valence(f), 4);
    }
    EXPECT_NEAR(signed_area(strip), input_area(strip.shape), 1e-12);
    // The middle third is a quad of no line.
    ASSERT_TRUE(strip.mesh.is_quad(middle));
    for (const HalfEdge h : strip.mesh.halfedges(middle)) EXPECT_FALSE(strip.mesh.is_constrained(M::edge(h)));
}

TEST(Rung, QuadsBetweenPartingLinesDoNotGetWiderAndWider) {
    // A wedge, narrow at x = 0, six times as wide at its other end.
    shapes::Shape wedge = shapes::grid(24, 8);
    for (Point& p : wedge.points) p.y() = (p.y() - 4.0) * (0.25 + 1.25 * p.x() / 24.0);
    const QuadMeshResult result = quad_mesh(wedge.points, wedge.triangles, {});
    EXPECT_EQ(result.report.inverted, 0);
    for (const auto& q : result.quads) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Point& a = result.points[static_cast<std::size_t>(q[k])];
            const Point& b = result.points[static_cast<std::size_t>(q[(k + 1) % 4])];
            EXPECT_LT((a - b).norm(), 3.0);
        }
    }
}

}  // namespace
}  // namespace anisoquad
