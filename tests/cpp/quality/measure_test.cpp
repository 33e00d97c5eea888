#include "quality/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "mesh/validate.h"
#include "quality/metrics.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// The mesh with the two triangles of every cell of a grid-like shape (as add_quad made them) paired.
SurfaceMesh paired(const shapes::Shape& shape, const std::vector<Source>& sources = {}) {
    SurfaceMesh mesh = shape.mesh();
    find_features(mesh, sources, {});
    find_patches(mesh);
    for (std::int32_t f = 0; f < mesh.face_slots(); f += 2) {
        for (const HalfEdge h : mesh.halfedges(Face(f))) {
            if (mesh.face(M::twin(h)) != Face(f + 1)) continue;
            dissolve_edge(mesh, M::edge(h));
            break;
        }
    }
    return mesh;
}

Report measured(const SurfaceMesh& mesh, const shapes::Shape& shape, const std::vector<Source>& sources = {}) {
    Report report;
    measure(mesh, ReferenceSurface(shape.points, shape.triangles), topology(shape.mesh()).euler_characteristic, report, sources);
    return report;
}

/// Marks the cells (i, j) of an nx wide grid of quads, as paired() makes it, as a row.
void mark_row(SurfaceMesh& mesh, int nx, int j, int row, int pass) {
    for (int i = 0; i < nx; ++i) {
        for (const std::int32_t f : {2 * (j * nx + i), 2 * (j * nx + i) + 1}) {
            if (mesh.is_deleted(Face(f))) continue;
            mesh.info(Face(f)).row = row;
            mesh.info(Face(f)).pass = pass;
            mesh.info(Face(f)).source = 0;
        }
    }
}

TEST(Measure, ARegularGridIsPerfect) {
    const shapes::Shape shape = shapes::grid(6, 4, 2.0, 1.0);
    const Report r = measured(paired(shape), shape);
    EXPECT_EQ(r.triangles_in, 48);
    EXPECT_EQ(r.quads, 24);
    EXPECT_EQ(r.nodes, 35);
    EXPECT_EQ(r.triangles_left, 0);
    EXPECT_EQ(r.inverted, 0);
    EXPECT_EQ(r.components, 1);
    EXPECT_EQ(r.euler_in, 1);
    EXPECT_EQ(r.euler_out, 1);
    EXPECT_NEAR(r.reduction_percent, 50.0, 1e-12);
    EXPECT_NEAR(r.scaled_jacobian.min, 1.0, 1e-12);
    EXPECT_NEAR(r.scaled_jacobian_min_elsewhere, 1.0, 1e-12);
    EXPECT_NEAR(r.aspect_ratio.mean, 2.0, 1e-12);
    EXPECT_NEAR(r.sharpest_corner, 90.0, 1e-9);
    EXPECT_NEAR(r.scaled_jacobian_limit, 1.0, 1e-12);
    EXPECT_NEAR(r.regular_percent, 100.0, 1e-12);
    ASSERT_EQ(r.valence_histogram.size(), 5u);
    EXPECT_EQ(r.valence_histogram[4], 15);
    EXPECT_NEAR(r.hausdorff, 0.0, 1e-12);
    EXPECT_EQ(r.neighbour_area_ratio_max, 1.0);
    EXPECT_TRUE(r.rows.empty());
}

TEST(Measure, CountsTrianglesThatAreLeft) {
    const shapes::Shape shape = shapes::grid(3, 3);
    SurfaceMesh mesh = paired(shape);
    const Face f(0);
    insert_edge(mesh, mesh.halfedge(f), mesh.next(mesh.next(mesh.halfedge(f))));
    const Report r = measured(mesh, shape);
    EXPECT_EQ(r.quads, 8);
    EXPECT_EQ(r.triangles_left, 2);
}

TEST(Measure, NamesTheWorstQuadByItsPlaceInTheArrays) {
    const shapes::Shape shape = shapes::grid(4, 4);
    SurfaceMesh mesh = paired(shape);
    mesh.position(Vertex(12)) += Point(0.6, 0.55, 0.0);
    const Report r = measured(mesh, shape);
    const MeshArrays arrays = to_arrays(mesh);
    const auto worst = [&](const Distribution& d) { return arrays.face_handles[static_cast<std::size_t>(d.worst)]; };
    EXPECT_DOUBLE_EQ(scaled_jacobian(mesh, worst(r.scaled_jacobian)), r.scaled_jacobian.min);
    EXPECT_DOUBLE_EQ(aspect_ratio(mesh, worst(r.aspect_ratio)), r.aspect_ratio.max);
    EXPECT_DOUBLE_EQ(min_angle(mesh, worst(r.min_angle)), r.min_angle.min);
    EXPECT_DOUBLE_EQ(max_angle(mesh, worst(r.max_angle)), r.max_angle.max);
    for (const Distribution& d : {r.scaled_jacobian, r.aspect_ratio, r.min_angle, r.max_angle, r.skew}) {
        EXPECT_LE(d.min, d.p5);
        EXPECT_LE(d.p5, d.mean);
        EXPECT_LE(d.mean, d.max);
        EXPECT_LE(d.p95, d.max);
    }
}

TEST(Measure, CountsFoldedQuadsAndQuadsThatAreTurnedOver) {
    const shapes::Shape shape = shapes::grid(4, 4);
    SurfaceMesh folded = paired(shape);
    folded.position(Vertex(12)) += Point(1.3, 1.2, 0.0);
    EXPECT_GE(measured(folded, shape).inverted, 1);
    SurfaceMesh turned = paired(shape);  // the cell (1, 1) mirrored at its middle, (6, 7, 12, 11)
    std::swap(turned.position(Vertex(6)), turned.position(Vertex(7)));
    std::swap(turned.position(Vertex(11)), turned.position(Vertex(12)));
    Report r = measured(turned, shape);
    EXPECT_GE(r.inverted, 1);
    bool whole = false;  // one of them has a good shape and lies upside down
    const MeshArrays arrays = to_arrays(turned);
    for (const Face f : arrays.face_handles)
        whole |= scaled_jacobian(turned, f) > 0.99 && scaled_jacobian(turned, f, {0, 0, 1}) < 0.0;
    EXPECT_TRUE(whole);
}

TEST(Measure, AThinBodyIsNotTakenForTurnedOver) {
    const shapes::Shape flat = [] {
        shapes::Shape shape = shapes::cube(8);
        for (Point& p : shape.points) p.z() *= 1e-4;
        return shape;
    }();
    EXPECT_EQ(measured(paired(flat), flat).inverted, 0);
}

/// A parallelogram of n × n cells whose corner at the origin has the given angle.
shapes::Shape wedge(int n, double degrees) {
    shapes::Shape shape = shapes::grid(n, n);
    const double angle = degrees * std::numbers::pi / 180.0;
    for (Point& p : shape.points) p = {p.x() + p.y() * std::cos(angle), p.y() * std::sin(angle), 0.0};
    return shape;
}

TEST(Measure, TheSharpestCornerLimitsTheScaledJacobian) {
    const shapes::Shape shape = wedge(4, 30.0);
    const Report r = measured(paired(shape), shape);
    EXPECT_NEAR(r.sharpest_corner, 30.0, 1e-9);
    EXPECT_NEAR(r.scaled_jacobian_limit, 0.5, 1e-12);
    EXPECT_NEAR(r.scaled_jacobian.min, 0.5, 1e-12);
    EXPECT_NEAR(r.scaled_jacobian_min_elsewhere, 0.5, 1e-12);  // the others are no better, so nothing is excused
}

TEST(Measure, OnlyCornersThatKeepTheirQuadDownAreExcused) {
    // A grid whose corner node 0 is pulled to an angle of 40°; the other quads stay better than that.
    shapes::Shape shape = shapes::grid(4, 4);
    shape.points[1] = {1.0, 0.3, 0.0};
    shape.points[5] = {0.5, 1.0, 0.0};
    SurfaceMesh mesh = paired(shape);
    const double angle = std::atan2(1.0, 0.5) - std::atan2(0.3, 1.0);
    double others = 1.0;
    const MeshArrays arrays = to_arrays(mesh);
    for (const Face f : arrays.face_handles) {
        bool corner = false;
        for (const HalfEdge h : mesh.halfedges(f)) corner |= mesh.from(h) == Vertex(0);
        if (!corner) others = std::min(others, scaled_jacobian(mesh, f));
    }
    ASSERT_GT(others, std::sin(angle));
    const Report r = measured(mesh, shape);
    EXPECT_NEAR(r.sharpest_corner, angle * 180.0 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(r.scaled_jacobian_limit, std::sin(angle), 1e-12);
    EXPECT_LE(r.scaled_jacobian.min, std::sin(angle) + 1e-12);
    EXPECT_NEAR(r.scaled_jacobian_min_elsewhere, others, 1e-12);
}

TEST(Measure, ClosedSmoothSurfacesHaveNoCorner) {
    const shapes::Shape shape = shapes::torus(40, 20);
    const Report r = measured(paired(shape), shape);
    EXPECT_EQ(r.sharpest_corner, 180.0);
    EXPECT_EQ(r.scaled_jacobian_limit, 1.0);
    EXPECT_EQ(r.euler_out, 0);
    EXPECT_NEAR(r.regular_percent, 100.0, 1e-12);
    EXPECT_EQ(r.quads, 800);
    EXPECT_GT(r.hausdorff, 0.0);  // the quads' halves are not the input's triangles everywhere
    EXPECT_LT(r.hausdorff_relative, 0.01);
}

TEST(Measure, DistanceCountsBothWays) {
    const shapes::Shape shape = shapes::grid(4, 4);
    SurfaceMesh raised = paired(shape);
    raised.position(Vertex(12)).z() = 0.25;
    EXPECT_NEAR(measured(raised, shape).hausdorff, 0.25, 1e-12);
    // a mesh that covers only a part of the input
    const shapes::Shape half = shapes::grid(2, 4);
    Report r;
    measure(paired(half), ReferenceSurface(shape.points, shape.triangles), 1, r);
    EXPECT_NEAR(r.hausdorff, 2.0, 1e-12);
    EXPECT_NEAR(r.hausdorff_relative, 2.0 / std::sqrt(32.0), 1e-12);
}

TEST(Measure, AQuadCountsAsItsTwoHalves) {
    shapes::Shape shape = shapes::grid(1, 1);
    shape.points[3].z() = 1.0;
    SurfaceMesh mesh = shape.mesh();
    const Face quad = dissolve_edge(mesh, M::edge(mesh.find_halfedge(Vertex(0), Vertex(3))));
    HalfEdge h = mesh.halfedge(quad);
    for (int k = 0; k < 4; ++k, h = mesh.next(h)) {
        mesh.set_halfedge(quad, h);
        const bool same_diagonal = mesh.from(h) == Vertex(0) || mesh.from(h) == Vertex(3);
        EXPECT_EQ(measured(mesh, shape).hausdorff < 1e-12, same_diagonal);
    }
}

TEST(Measure, RowsOnBothSidesOfASource) {
    // Rows of heights 0.5, 1 (above) and 0.25 (below) around y = 0, columns of 2.
    shapes::Shape shape = shapes::grid(5, 5);
    const double y[] = {-2.0, -0.25, 0.0, 0.5, 1.5, 4.0};
    for (Point& p : shape.points) p = {2.0 * p.x(), y[static_cast<int>(std::lround(p.y()))], 0.0};
    const std::vector<Source> sources{{{12, 13, 14, 15, 16, 17}, {{2, 2}}, Sides::both}};
    SurfaceMesh mesh = paired(shape, sources);
    mark_row(mesh, 5, 1, 1, 1);
    mark_row(mesh, 5, 2, 1, 1);
    mark_row(mesh, 5, 3, 2, 2);
    const Report r = measured(mesh, shape, sources);
    ASSERT_EQ(r.rows.size(), 3u);
    const auto expect_row = [](const RowReport& row, const char* side, int number, int pass, double height) {
        EXPECT_EQ(row.source, 0);
        EXPECT_EQ(row.side, side);
        EXPECT_EQ(row.row, number);
        EXPECT_EQ(row.pass, pass);
        EXPECT_EQ(row.quads, 5);
        EXPECT_NEAR(row.height_mean, height, 1e-12);
        EXPECT_NEAR(row.aspect_mean, 2.0 / height, 1e-12);
    };
    expect_row(r.rows[0], "left", 1, 1, 0.5);
    expect_row(r.rows[1], "left", 2, 2, 1.0);
    expect_row(r.rows[2], "right", 1, 1, 0.25);
    EXPECT_NEAR(r.neighbour_area_ratio_max, 1.75 / 0.25, 1e-9);

    const std::vector<Source> backwards{{{17, 16, 15, 14, 13, 12}, {}, Sides::both}};
    const Report b = measured(mesh, shape, backwards);
    ASSERT_EQ(b.rows.size(), 3u);
    expect_row(b.rows[0], "left", 1, 1, 0.25);
    expect_row(b.rows[1], "right", 1, 1, 0.5);
}

TEST(Measure, RowsAroundAClosedSource) {
    const shapes::Shape shape = shapes::cylinder(16, 4);
    std::vector<std::int32_t> ring;
    for (int i = 0; i <= 16; ++i) ring.push_back(32 + i % 16);
    const std::vector<Source> sources{{ring, {}, Sides::both}};
    SurfaceMesh mesh = paired(shape, sources);
    mark_row(mesh, 16, 1, 1, 1);
    mark_row(mesh, 16, 2, 1, 1);
    const Report r = measured(mesh, shape, sources);
    ASSERT_EQ(r.rows.size(), 2u);
    EXPECT_EQ(r.rows[0].side, "left");
    EXPECT_EQ(r.rows[1].side, "right");
    for (const RowReport& row : r.rows) {
        EXPECT_EQ(row.quads, 16);
        EXPECT_NEAR(row.height_mean, 0.5, 1e-12);
    }
}

TEST(Measure, FiguresScaleWithTheModel) {
    const shapes::Shape shape = shapes::torus(24, 12);
    SurfaceMesh mesh = paired(shape);
    const Report r = measured(mesh, shape);
    for (const double scale : {1e-6, 1e6}) {
        const shapes::Shape big = shapes::placed(shape, scale, {100 * scale, 0, 0});
        const Report s = measured(paired(big), big);
        EXPECT_NEAR(s.scaled_jacobian.p5, r.scaled_jacobian.p5, 1e-9);
        EXPECT_NEAR(s.hausdorff / scale, r.hausdorff, 1e-9);
        EXPECT_NEAR(s.hausdorff_relative, r.hausdorff_relative, 1e-9);
        EXPECT_EQ(s.inverted, 0);
    }
}

}  // namespace
}  // namespace anisoquad
