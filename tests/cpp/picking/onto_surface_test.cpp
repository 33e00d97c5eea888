#include "picking/onto_surface.h"

#include <gtest/gtest.h>

#include <array>

#include "picking/picking_shapes.h"

namespace anisoquad {
namespace {

TEST(OntoSurface, MiddlesOfChordsComeNearerToTheSphere) {
    const PickSurface surface = shapes::pick_surface(shapes::sphere(80, 50));
    std::vector<Point> middles;
    for (std::int32_t e = 0; e < surface.mesh.edge_slots(); ++e) {
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        middles.push_back(0.5 * (surface.mesh.position(surface.mesh.from(h)) + surface.mesh.position(surface.mesh.to(h))));
    }
    const std::vector<char> none(middles.size(), 0);
    const std::span<const bool> mask(reinterpret_cast<const bool*>(none.data()), none.size());
    const std::vector<Point> moved = onto_surface(surface, middles, mask);
    double before = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        before = std::max(before, std::abs(1.0 - middles[i].norm()));
        after = std::max(after, std::abs(1.0 - moved[i].norm()));
    }
    EXPECT_LT(after, 0.3 * before);
}

TEST(OntoSurface, PointsOnLinesComeOntoTheNearestLine) {
    const PickSurface surface = shapes::pick_surface(shapes::roof(6, 3, 90.0));
    const std::array<bool, 2> mask{true, false};
    const std::vector<Point> points{Point(2.5, 0.2, -0.1), Point(2.5, 0.2, -0.1)};
    const std::vector<Point> moved = onto_surface(surface, points, mask);
    EXPECT_LT((moved[0] - Point(2.5, 0.0, 0.0)).norm(), 1e-12);
    EXPECT_GT(moved[1].y(), 0.1);
    EXPECT_NEAR(moved[1].z(), -moved[1].y(), 1e-9) << "on the slope";
}

}  // namespace
}  // namespace anisoquad
