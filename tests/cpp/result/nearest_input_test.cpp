#include "result/nearest_input.h"

#include <gtest/gtest.h>

#include "mesh/euler_operators.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

/// A strip of quads over the same strip of triangles: below each quad lies one of its two triangles.
TEST(NearestInput, IsBelowTheQuadsAndAtTheLines) {
    const shapes::Shape shape = shapes::grid(4, 1);
    Prepared p(shape);
    const std::vector<FeatureLine> found = find_features(p.mesh, {}, {});
    const ReferenceLines lines(p.mesh, found);
    for (std::int32_t e = 0; e < p.mesh.edge_slots(); ++e) {
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        const auto& a = p.mesh.position(p.mesh.from(h));
        const auto& b = p.mesh.position(p.mesh.to(h));
        if (a.x() != b.x() && a.y() != b.y()) dissolve_edge(p.mesh, Edge(e));
    }
    QuadMeshResult result;
    find_nearest_input(p.mesh, p.reference, lines, result);
    ASSERT_EQ(result.quad_facet.size(), 4U);
    std::size_t k = 0;
    for (const Face f : faces(p.mesh)) {
        const auto& triangle = shape.triangles[static_cast<std::size_t>(result.quad_facet[k++])];
        for (const std::int32_t v : triangle) {
            bool is_corner = false;
            for (const HalfEdge h : p.mesh.halfedges(f))
                is_corner |= p.mesh.position(p.mesh.from(h)) == shape.points[static_cast<std::size_t>(v)];
            EXPECT_TRUE(is_corner);
        }
    }
    ASSERT_EQ(result.line_edge_input.size(), 10U);
    for (const auto& [a, b] : result.line_edge_input) {
        const Point along = shape.points[static_cast<std::size_t>(a)] - shape.points[static_cast<std::size_t>(b)];
        EXPECT_NEAR(along.norm(), 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace anisoquad
