#include "smoothing/row_end_smoothing.h"

#include <gtest/gtest.h>

#include "features/feature_lines.h"
#include "quad_grid.h"
#include "smoothing/line_smoothing.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

constexpr int kColumns = 6;
constexpr int kRows = 6;
constexpr int kAnisotropic = 2;  ///< rows; the others are of squares
constexpr double kWidth = 1.0 / kColumns;

/// Two rows of a height over squares; where `far_height` differs, the first row of them is as high as that.
Grid grid_behind_rows(double height, double far_height = kWidth) {
    return make(kColumns, kRows, on_plane, [&](int i, int j) {
        double y = std::min(j, kAnisotropic) * height;
        if (j > kAnisotropic) y += far_height + (j - kAnisotropic - 1) * kWidth;
        return std::pair(i * kWidth, y);
    });
}

struct Case {
    SurfaceMesh mesh;
    ReferenceLines lines;
};

/// With the lines of the grid's border.
Case case_of(const Grid& g) {
    SurfaceMesh mesh = from_arrays(g.points, g.triangles);
    const std::vector<FeatureLine> found = find_features(mesh, {}, {});
    ReferenceLines lines(mesh, found);
    for (std::size_t k = 0; k < g.triangles.size(); k += 2) {
        dissolve_edge(mesh, SurfaceMesh::edge(mesh.find_halfedge(Vertex(g.triangles[k][0]), Vertex(g.triangles[k][2]))));
    }
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
        if (!mesh.is_deleted(Face(f))) mesh.info(Face(f)).patch = 0;
    }
    for (int j = 0; j < kAnisotropic; ++j) {
        for (int i = 0; i < kColumns; ++i)
            mesh.info(mesh.face(mesh.find_halfedge(g.vertex(i, j), g.vertex(i + 1, j)))).row = j + 1;
    }
    for (int j = 0; j <= kAnisotropic; ++j) {
        for (int i = 0; i <= kColumns; ++i) mesh.info(g.vertex(i, j)).in_row = true;
    }
    return {std::move(mesh), std::move(lines)};
}

double largest_ratio(const SurfaceMesh& mesh, const Grid& g) {
    double most = 1.0;
    for (int i = 0; i < kColumns; ++i) {
        const HalfEdge h = mesh.find_halfedge(g.vertex(i, kAnisotropic), g.vertex(i + 1, kAnisotropic));
        const double a = area(mesh, mesh.face(h));
        const double b = area(mesh, mesh.face(SurfaceMesh::twin(h)));
        most = std::max(most, std::max(a, b) / std::min(a, b));
    }
    return most;
}

TEST(RowEndSmoothing, MakesLargeQuadsBehindTheRowsSmaller) {
    const Grid g = grid_behind_rows(0.3 * kWidth);
    Case c = case_of(g);
    ASSERT_NEAR(largest_ratio(c.mesh, g), 1.0 / 0.3, 1e-9);
    EXPECT_GT(even_row_ends(c.mesh, g.reference(), c.lines), 0);
    EXPECT_LT(largest_ratio(c.mesh, g), 1.05 * kMostSizeRatio);
    for (std::int32_t v = 0; v < c.mesh.vertex_slots(); ++v) {
        EXPECT_EQ(c.mesh.position(Vertex(v)).z(), 0.0);
        if (c.mesh.info(Vertex(v)).in_row) {
            EXPECT_EQ(c.mesh.position(Vertex(v)), g.points[static_cast<std::size_t>(v)]);
        }
    }
    for (std::int32_t f = 0; f < c.mesh.face_slots(); ++f) {
        if (!c.mesh.is_deleted(Face(f))) {
            EXPECT_GE(scaled_jacobian(c.mesh, Face(f)), 0.6);
        }
    }
}

TEST(RowEndSmoothing, MakesSmallOnesLarger) {
    const Grid g = grid_behind_rows(kWidth, 0.3 * kWidth);
    Case c = case_of(g);
    even_row_ends(c.mesh, g.reference(), c.lines);
    EXPECT_LT(largest_ratio(c.mesh, g), 1.05 * kMostSizeRatio);
}

TEST(RowEndSmoothing, LeavesWhatIsEvenAlone) {
    const Grid g = grid_behind_rows(0.55 * kWidth);
    Case c = case_of(g);
    EXPECT_EQ(even_row_ends(c.mesh, g.reference(), c.lines), 0);
    EXPECT_NEAR(largest_ratio(c.mesh, g), 1.0 / 0.55, 1e-9);
}

/// The left and the right column, whose far nodes lie on the border, can only follow where these slide.
TEST(RowEndSmoothing, SlidesNodesOfLinesAlongThem) {
    const Grid g = grid_behind_rows(0.3 * kWidth);
    Case c = case_of(g);
    even_row_ends(c.mesh, g.reference(), c.lines);
    const Vertex v = g.vertex(0, kAnisotropic + 1);
    EXPECT_LT(c.mesh.position(v).y(), g.points[static_cast<std::size_t>(v.index())].y() - 0.1 * kWidth);
    EXPECT_NEAR(c.mesh.position(v).x(), 0.0, 1e-12);

    Case without = case_of(g);
    even_row_ends(without.mesh, g.reference(), {});
    EXPECT_EQ(without.mesh.position(v), g.points[static_cast<std::size_t>(v.index())]);
}

}  // namespace
}  // namespace anisoquad
