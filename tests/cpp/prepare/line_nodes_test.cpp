#include "prepare/line_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/patches.h"
#include "mesh/arrays.h"
#include "mesh/validate.h"
#include "strip_cylinder.h"

namespace anisoquad {
namespace {

/// A cylinder's lower rim is spread anew at the given size.
std::vector<double> edges_of_rim(double size, double deviation, SurfaceMesh& mesh, bool equal_parts = false) {
    const Surface s = strip_cylinder(48, 12, 0.3);
    mesh = from_arrays(s.points, s.triangles);
    const std::vector<FeatureLine> lines = find_features(mesh, {}, {});
    find_patches(mesh);
    const ReferenceLines reference(mesh, lines);
    const ReferenceSurface surface(s.points, s.triangles);
    std::vector<LineNodes> chains = line_nodes(mesh, lines, reference);
    for (int sweep = 0; sweep < 10; ++sweep) {
        for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) mesh.info(Vertex(i)).size = size;
        redistribute_line_nodes(mesh, chains[0], reference, surface, {deviation, 0.05, nullptr, equal_parts});
    }
    EXPECT_TRUE(validate(mesh).empty());
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < chains[0].nodes.size(); ++i) {
        const HalfEdge h = mesh.find_halfedge(chains[0].nodes[i], chains[0].nodes[i + 1]);
        EXPECT_TRUE(h.is_valid() && mesh.is_constrained(SurfaceMesh::edge(h)));
        lengths.push_back(mesh.length(h));
    }
    return lengths;
}

TEST(RedistributeLineNodes, LongEdgesAreSplitIntoEqualOnes) {
    SurfaceMesh mesh;
    const std::vector<double> lengths = edges_of_rim(0.005, 1e-3, mesh);
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    EXPECT_LT(*most, 0.005 * 4.0 / 3.0 + 1e-9);
    EXPECT_LT(*most, 1.5 * *least);
}

TEST(RedistributeLineNodes, EqualPartsFitTheSizeToo) {
    for (const double size : {0.0015, 0.0022, 0.0031, 0.005}) {
        SurfaceMesh mesh;
        const std::vector<double> lengths = edges_of_rim(size, 1e-3, mesh, true);
        const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
        EXPECT_LT(*most, size * 4.0 / 3.0 + 1e-9);
        EXPECT_GT(*least, 0.6 * size);
    }
}

TEST(RedistributeLineNodes, ShortEdgesAreMergedAsFarAsTheLineAllows) {
    SurfaceMesh mesh;
    const double radius = 0.1;
    EXPECT_LT(edges_of_rim(0.04, 2e-3, mesh).size(), 24U);
    // An edge of length L leaves the circle by L²/8r: a close bound keeps the polyline's own nodes.
    EXPECT_EQ(edges_of_rim(0.04, 1e-6 * radius, mesh).size(), 48U);
}

}  // namespace
}  // namespace anisoquad
