#include "smoothing/onto_target.h"

#include <gtest/gtest.h>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "quad_mesh.h"
#include "shapes.h"

namespace anisoquad {
namespace {

/// The band of the radius 1 round z; remembers how many of its points were asked for on an edge.
class Band : public TargetSurface {
  public:
    void project(std::span<const TargetPlace> places, std::span<Eigen::Vector3d> points) const override {
        for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_GE(places[i].facet, 0);
            EXPECT_NEAR(places[i].weights.sum(), 1.0, 1e-9);
            points[i].head<2>().normalize();
            if (places[i].edge[0] < 0) continue;
            EXPECT_GE(places[i].share, 0.0);
            EXPECT_LE(places[i].share, 1.0);
            points[i].z() = points[i].z() > 1.0 ? 2.0 : 0.0;
        }
    }
};

TEST(OntoTarget, MovesWhatIsNotAtItsInputPlace) {
    const shapes::Shape band = shapes::cylinder(24, 6);
    SurfaceMesh mesh = band.mesh();
    const std::vector<FeatureLine> lines = find_features(mesh, {}, {});
    find_patches(mesh);
    const ReferenceLines reference_lines(mesh, lines);
    ReferenceSurface reference(band.points, band.triangles);
    const Band target;
    reference.set_target({&target, Point::Zero(), 1.0});
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        if (i % 3 == 0) continue;
        mesh.position(Vertex(i)) *= 0.99;
        mesh.info(Vertex(i)).input = -1;
    }
    const OntoTargetResult result = move_onto_target(mesh, reference, reference_lines);
    EXPECT_EQ(result.moved, mesh.vertex_slots() - (mesh.vertex_slots() + 2) / 3);
    EXPECT_EQ(result.inverted, 0);
    EXPECT_GT(result.largest_move, 0.009);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Point& p = mesh.position(Vertex(i));
        EXPECT_NEAR(p.head<2>().norm(), 1.0, 1e-12);
        if (mesh.is_boundary(Vertex(i))) {
            EXPECT_TRUE(p.z() == 0.0 || p.z() == 2.0) << p.z();
        }
    }
}

TEST(OntoTarget, AWholeMeshLiesOnItsTargetWhereverTheModelIs) {
    shapes::Shape band = shapes::cylinder(24, 6);
    const Band target;
    Options options;
    options.size = 0.2;
    options.validate = true;
    const QuadMeshResult onto = quad_mesh(band.points, band.triangles, {}, options, no_context(), &target);
    const QuadMeshResult alone = quad_mesh(band.points, band.triangles, {}, options);
    double off_alone = 0.0;
    for (const Point& p : onto.points) EXPECT_NEAR(p.head<2>().norm(), 1.0, 1e-12);
    for (const Point& p : alone.points) off_alone = std::max(off_alone, std::abs(p.head<2>().norm() - 1.0));
    EXPECT_GT(off_alone, 1e-6);
    EXPECT_EQ(onto.report.inverted, 0);
    EXPECT_EQ(onto.quad_facet.size(), onto.quads.size());
    EXPECT_EQ(onto.line_edge_input.size(), onto.line_edges.size());
    EXPECT_TRUE(alone.quad_facet.empty());
    for (const auto& [a, b] : onto.line_edge_input) {
        EXPECT_EQ(band.points[static_cast<std::size_t>(a)].z(), band.points[static_cast<std::size_t>(b)].z())
            << "an edge of a rim";
    }
}

}  // namespace
}  // namespace anisoquad
