#include "smoothing/shape_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/validate.h"
#include "parallel.h"
#include "quad_grid.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

class ShapeRelaxation : public testing::TestWithParam<Map> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, ShapeRelaxation, testing::Values(&on_plane, &on_sphere, &on_cylinder), name_of);

TEST_P(ShapeRelaxation, MakesDistortedGridsEven) {
    const Grid g = make(32, 32, GetParam());
    const ReferenceSurface reference = g.reference();
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, GetParam(), 0.15);
    const Quality before = quality(mesh);
    EXPECT_GT(relax_shapes(mesh, reference), 31 * 31 / 2);
    const Quality after = quality(mesh);
    EXPECT_LT(1.0 - after.mean, 0.2 * (1.0 - before.mean));
    EXPECT_GT(after.min, before.min);
    EXPECT_TRUE(validate(mesh).empty());
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i)
        EXPECT_LE(reference.closest(mesh.position(Vertex(i))).distance, 5.01e-4 * reference.diagonal());
}

TEST_P(ShapeRelaxation, LeavesLinesAndRowsAlone) {
    const Grid g = make(16, 16, GetParam());
    SurfaceMesh mesh = g.mesh();
    distort(mesh, g, GetParam(), 0.2);
    for (int i = 0; i <= 16; ++i) {
        mesh.info(g.vertex(i, 6)).kind = NodeKind::line;
        mesh.info(g.vertex(i, 10)).in_row = true;
    }
    const SurfaceMesh before = mesh;
    relax_shapes(mesh, g.reference());
    for (int i = 0; i <= 16; ++i) {
        for (const int j : {0, 6, 10, 16}) EXPECT_EQ(mesh.position(g.vertex(i, j)), before.position(g.vertex(i, j)));
        EXPECT_EQ(mesh.position(g.vertex(0, i)), before.position(g.vertex(0, i)));
    }
    EXPECT_NE(mesh.position(g.vertex(8, 8)), before.position(g.vertex(8, 8)));
}

TEST_P(ShapeRelaxation, NothingPoorBecomesPoorer) {
    const Grid g = make(20, 20, GetParam());
    const ReferenceSurface reference = g.reference();
    for (unsigned seed = 0; seed < 20; ++seed) {
        SurfaceMesh mesh = g.mesh();
        distort(mesh, g, GetParam(), 0.45, seed);
        // Corners that nothing can move, far from where the quads would like them.
        for (int i = 4; i <= 16; i += 4) mesh.info(g.vertex(i, 9)).kind = NodeKind::corner;
        std::vector<double> before;
        for (std::int32_t f = 0; f < mesh.face_slots(); ++f)
            before.push_back(mesh.is_deleted(Face(f)) ? 1.0 : scaled_jacobian(mesh, Face(f)));
        relax_shapes(mesh, reference);
        for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
            if (mesh.is_deleted(Face(f))) continue;
            EXPECT_GE(scaled_jacobian(mesh, Face(f)), std::min(before[static_cast<std::size_t>(f)], Star::kPoor)) << seed;
        }
    }
}

/// What is bent over many quads: without momentum four fifths of it would be left.
TEST(ShapeRelaxation, LongWavesBecomeStraight) {
    constexpr int kCells = 24;
    constexpr double kDepth = 1.0 / kCells;
    const Grid g = make(kCells, kCells, on_plane);
    SurfaceMesh mesh = g.mesh();
    for (int j = 1; j < kCells; ++j) {
        for (int i = 1; i < kCells; ++i) {
            const double x = std::sin(std::numbers::pi * i / kCells);
            const double y = std::sin(2.0 * std::numbers::pi * j / kCells);
            mesh.position(g.vertex(i, j)).x() += kDepth * x * y;
        }
    }
    const Quality before = quality(mesh);
    relax_shapes(mesh, g.reference());
    double most = 0.0;
    for (int j = 0; j <= kCells; ++j) {
        for (int i = 0; i <= kCells; ++i)
            most = std::max(most,
                            (mesh.position(g.vertex(i, j)) - g.points[static_cast<std::size_t>(g.vertex(i, j).index())]).norm());
    }
    EXPECT_LT(most, 0.25 * kDepth);
    EXPECT_GT(quality(mesh).min, before.min);
}

TEST(ShapeRelaxation, IsTheSameForAnyNumberOfThreads) {
    const Grid g = make(100, 100, on_sphere);
    const ReferenceSurface reference = g.reference();
    SurfaceMesh start = g.mesh();
    distort(start, g, on_sphere, 0.3);
    SurfaceMesh alone = start;
    with_threads(1, [&] { return relax_shapes(alone, reference); });
    for (const int threads : {2, 3}) {
        SurfaceMesh mesh = start;
        with_threads(threads, [&] { return relax_shapes(mesh, reference); });
        for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) ASSERT_EQ(mesh.position(Vertex(i)), alone.position(Vertex(i)));
    }
}

TEST(ShapeRelaxation, CanBeCancelled) {
    const Grid g = make(8, 8, on_plane);
    SurfaceMesh mesh = g.mesh();
    const Context no([](std::string_view, double) { return false; });
    EXPECT_THROW(relax_shapes(mesh, g.reference(), no), Error);
}

TEST(ShapeRelaxation, AMeshWithoutFreeNodesStaysAsItIs) {
    const Grid g = make(1, 3, on_plane);
    SurfaceMesh mesh = g.mesh();
    EXPECT_EQ(relax_shapes(mesh, g.reference()), 0);
}

}  // namespace
}  // namespace anisoquad
