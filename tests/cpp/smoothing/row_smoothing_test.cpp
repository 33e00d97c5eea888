#include "smoothing/row_smoothing.h"

#include <gtest/gtest.h>

#include "quad_grid.h"

namespace anisoquad {
namespace {

using namespace quad_grid;

constexpr int kColumns = 8;
constexpr int kRows = 4;  ///< rows 1…3 are anisotropic, the last one is not
constexpr double kHeight = 0.02;

/// Columns as wide as 1/8, rows from the source y = 0 that grow by 1.2, and one row of squares.
Grid rows_grid(Point (*map)(double, double)) {
    return make(kColumns, kRows, map, [](int i, int j) {
        double y = 0.0;
        double h = kHeight;
        for (int k = 0; k < j; ++k, h *= 1.2) y += k + 1 < kRows ? h : 1.0 / kColumns;
        return std::pair(double(i) / kColumns, y);
    });
}

SurfaceMesh rows_mesh(const Grid& g) {
    SurfaceMesh mesh = g.mesh();
    for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i < kColumns; ++i) {
            const HalfEdge h = mesh.find_halfedge(g.vertex(i, j), g.vertex(i + 1, j));
            FaceInfo& info = mesh.info(mesh.face(h));
            if (j + 1 < kRows) info.row = j + 1;
            info.source = j + 1 < kRows ? 0 : -1;
            if (j == 0) mesh.info(SurfaceMesh::edge(h)).source = true;
        }
    }
    for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i <= kColumns; ++i) mesh.info(g.vertex(i, j)).in_row = true;
    }
    return mesh;
}

/// Distance of node (i, j) from the row below, across it.
double height(const SurfaceMesh& mesh, const Grid& g, int i, int j) {
    const Point& a = mesh.position(g.vertex(i - 1, j - 1));
    const Eigen::Vector3d along = (mesh.position(g.vertex(i + 1, j - 1)) - a).normalized();
    const Eigen::Vector3d off = mesh.position(g.vertex(i, j)) - mesh.position(g.vertex(i, j - 1));
    return (off - off.dot(along) * along).norm();
}

class Rows : public testing::TestWithParam<Map> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, Rows, testing::Values(&on_plane, &on_sphere, &on_cylinder), name_of);

TEST_P(Rows, ShearedColumnsAreStraightenedAndHeightsKept) {
    const Grid g = rows_grid(GetParam());
    SurfaceMesh mesh = rows_mesh(g);
    // Every layer is pushed along the row by a different amount.
    for (int j = 1; j < kRows; ++j) {
        for (int i = 1; i < kColumns; ++i) {
            double y = 0.0;
            double h = kHeight;
            for (int k = 0; k < j; ++k, h *= 1.2) y += h;
            mesh.position(g.vertex(i, j)) = GetParam()((i + 0.15 * std::sin(3.0 * i + 2.0 * j)) / kColumns, y);
        }
    }
    std::vector<double> aspect;
    std::vector<double> heights;
    for (int j = 1; j < kRows; ++j) {
        for (int i = 1; i < kColumns; ++i) heights.push_back(height(mesh, g, i, j));
    }
    const Quality before = quality(mesh);
    const ReferenceSurface reference = g.reference();
    const RowSmoothingResult result = smooth_rows(mesh, &reference, 10);
    EXPECT_GT(result.moved, 0);
    const Quality after = quality(mesh);
    EXPECT_GT(after.mean, before.mean);
    EXPECT_GT(after.min, before.min);
    EXPECT_GT(after.min, 0.85);
    std::size_t k = 0;
    for (int j = 1; j < kRows; ++j) {
        for (int i = 1; i < kColumns; ++i) EXPECT_NEAR(height(mesh, g, i, j) / heights[k++], 1.0, 0.05);
    }
    for (int j = 0; j + 1 < kRows; ++j) {
        const Grid ideal = rows_grid(GetParam());
        for (int i = 0; i < kColumns; ++i) {
            const double wanted = aspect_ratio(ideal.points[std::size_t(ideal.vertex(i, j).index())],
                                               ideal.points[std::size_t(ideal.vertex(i + 1, j).index())],
                                               ideal.points[std::size_t(ideal.vertex(i + 1, j + 1).index())],
                                               ideal.points[std::size_t(ideal.vertex(i, j + 1).index())]);
            const Face f = mesh.face(mesh.find_halfedge(g.vertex(i, j), g.vertex(i + 1, j)));
            // The sphere's grid is oblique by itself: straightened columns are a little nearer or farther than its own.
            EXPECT_NEAR(aspect_ratio(mesh, f) / wanted, 1.0, GetParam() == &on_sphere ? 0.15 : 0.05);
        }
    }
}

// On the sphere the grid is oblique, and its rows are not good yet.
class GoodRows : public testing::TestWithParam<Map> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, GoodRows, testing::Values(&on_plane, &on_cylinder), name_of);

TEST_P(GoodRows, StayAsTheyAre) {
    const Grid g = rows_grid(GetParam());
    SurfaceMesh mesh = rows_mesh(g);
    const ReferenceSurface reference = g.reference();
    smooth_rows(mesh, &reference);
    for (int j = 1; j < kRows; ++j) {
        for (int i = 1; i < kColumns; ++i)
            EXPECT_LT((mesh.position(g.vertex(i, j)) - g.points[std::size_t(g.vertex(i, j).index())]).norm(), 0.1 * kHeight);
    }
}

TEST_P(Rows, SourceBoundaryAndFreeNodesStay) {
    const Grid g = rows_grid(GetParam());
    SurfaceMesh mesh = rows_mesh(g);
    distort(mesh, g, GetParam(), 0.0);
    const SurfaceMesh before = mesh;
    smooth_rows(mesh, nullptr);
    for (int j = 0; j <= kRows; ++j) {
        for (int i = 0; i <= kColumns; ++i) {
            if (j > 0 && j < kRows && i > 0 && i < kColumns) continue;
            EXPECT_EQ(mesh.position(g.vertex(i, j)), before.position(g.vertex(i, j)));
        }
    }
}

/// An edge on top of the rows leans, and the node below it may slide after it.
struct LeaningTop {
    Grid g = rows_grid(&on_plane);
    SurfaceMesh mesh = rows_mesh(g);
    Vertex v = g.vertex(4, kRows - 1);

    explicit LeaningTop(double lean) { mesh.position(g.vertex(4, kRows)).x() += lean; }
    double worst() const {
        double q = 1.0;
        for (const HalfEdge h : mesh.outgoing(v)) q = std::min(q, scaled_jacobian(mesh, mesh.face(h)));
        return q;
    }
    double offset() const { return mesh.position(v).x() - mesh.position(g.vertex(4, kRows - 2)).x(); }
};

TEST(SlideInRow, GoesToWhereTheWorstElementIsBest) {
    LeaningTop top(0.05);
    const double before = top.worst();
    const double height = top.mesh.position(top.v).y();
    EXPECT_TRUE(slide_in_row(top.mesh, top.v, nullptr));
    EXPECT_GT(top.worst(), before);
    EXPECT_GT(top.offset(), 0.0);
    EXPECT_DOUBLE_EQ(top.mesh.position(top.v).y(), height);
}

TEST(SlideInRow, NeverBendsTheColumnFar) {
    LeaningTop top(0.09);
    for (int k = 0; k < 20; ++k) slide_in_row(top.mesh, top.v, nullptr);
    const double row_height = kHeight * 1.2 * 1.2;
    EXPECT_GT(top.offset(), 0.1 * row_height);
    EXPECT_LE(top.offset(), 0.3501 * row_height);
}

}  // namespace
}  // namespace anisoquad
