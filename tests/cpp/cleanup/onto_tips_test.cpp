#include "cleanup/onto_tips.h"

#include <gtest/gtest.h>

#include "qmorph/qmorph.h"
#include "smoothing/move_node.h"
#include "stages.h"

namespace anisoquad {
namespace {

/// A cone filled with quads, its top and the surface.
struct FilledCone {
    stages::Prepared prepared{shapes::cone(16, 8, 1.5)};
    SurfaceMesh& mesh = prepared.mesh;
    std::vector<Tip> tips = find_tips(mesh);

    FilledCone() { fill_with_quads(mesh, &prepared.reference); }

    std::vector<Vertex> nodes_at(const Point& p) const {
        std::vector<Vertex> found;
        for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
            if (!mesh.is_deleted(Vertex(i)) && mesh.position(Vertex(i)) == p) found.emplace_back(i);
        }
        return found;
    }
};

TEST(MoveOntoTips, PutsOneNodeThereAndHoldsIt) {
    FilledCone cone;
    ASSERT_EQ(cone.tips.size(), 1u);
    // Off the top, as the fill leaves it on coarser surfaces.
    for (const Vertex v : cone.nodes_at(cone.tips[0].place)) cone.mesh.position(v) += Point(0.02, 0.01, -0.04);
    EXPECT_EQ(move_onto_tips(cone.mesh, cone.prepared.reference, cone.tips), 1);
    const std::vector<Vertex> nodes = cone.nodes_at(cone.tips[0].place);
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_FALSE(is_movable(cone.mesh, nodes[0]));
    EXPECT_EQ(cone.mesh.info(nodes[0]).input, cone.tips[0].input);
    for (const HalfEdge h : cone.mesh.outgoing(nodes[0])) EXPECT_GT(scaled_jacobian(cone.mesh, cone.mesh.face(h)), 0.05);
    EXPECT_EQ(move_onto_tips(cone.mesh, cone.prepared.reference, cone.tips), 0) << "a second time it is there";
}

TEST(MoveOntoTips, LeavesATipThatNoNodeReaches) {
    FilledCone cone;
    const Tip far{Point(0.0, 0.0, 30.0), 0, -1};
    const MeshArrays before = to_arrays(cone.mesh);
    EXPECT_EQ(move_onto_tips(cone.mesh, cone.prepared.reference, std::span(&far, 1)), 0);
    EXPECT_EQ(to_arrays(cone.mesh).points, before.points);
}

}  // namespace
}  // namespace anisoquad
