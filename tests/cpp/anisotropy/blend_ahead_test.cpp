#include "anisotropy/blend_ahead.h"

#include <gtest/gtest.h>

#include "anisotropy/multi_pass.h"
#include "mesh/arrays.h"
#include "qmorph/front.h"
#include "qmorph/node_size.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

constexpr int kNx = 64;
constexpr int kNy = 80;

/// A plane with the rows of one source, before the blend.
struct WithRows : Prepared {
    WithRows() : Prepared(shapes::grid(kNx, kNy), lines()) {
        const LocalSize size(shape.points, shape.triangles, reference);
        const auto sources = lines();
        build_anisotropic_rows(mesh, sources, size, reference, {});
        assign_node_sizes(mesh);
    }
    static std::vector<Source> lines() { return {source(path(20 * (kNx + 1), 20 * (kNx + 1) + kNx, 1), {{4, 3}, {2, 2}})}; }
};

std::vector<HalfEdge> front_of_rows(const SurfaceMesh& mesh) {
    std::vector<HalfEdge> all;
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge h(i);
        if (mesh.is_deleted(h) || !is_front(mesh, h)) continue;
        const Face behind = mesh.face(SurfaceMesh::twin(h));
        if (behind.is_valid() && mesh.info(behind).row > 0) all.push_back(h);
    }
    return all;
}

/// Mean length of the triangles' edges between two heights of the plane.
double mean_length(const SurfaceMesh& mesh, double low, double high) {
    double sum = 0.0;
    int n = 0;
    for (const Edge e : edges(mesh)) {
        const HalfEdge h = SurfaceMesh::halfedge(e);
        const double y = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))).y();
        if (mesh.is_constrained(e) || y < low || y > high) continue;
        sum += mesh.length(e);
        ++n;
    }
    return sum / n;
}

TEST(BlendAhead, TrianglesAheadOfTheRowsBecomeAsLargeAsTheirEdges) {
    WithRows p;
    const auto front = front_of_rows(p.mesh);
    ASSERT_FALSE(front.empty());
    double top = 0.0;
    double longest = 0.0;
    for (const HalfEdge h : front) {
        top = std::max(top, p.mesh.position(p.mesh.from(h)).y());
        longest = std::max(longest, p.mesh.length(h));
    }
    ASSERT_GT(longest, 1.9);
    blend_ahead_of_rows(p.mesh, p.reference);
    expect_sound(p);
    EXPECT_EQ(inverted_triangles(p), 0);
    const double before = 1.14;  // mean of a cell's edges 1, 1 and its diagonal
    EXPECT_GT(mean_length(p.mesh, top, top + longest), 1.1 * before);
    EXPECT_LT(mean_length(p.mesh, top, top + longest), 1.5 * longest);
    EXPECT_NEAR(mean_length(p.mesh, kNy - 10, kNy), before, 0.15 * before);
    for (const Vertex v : vertices(p.mesh)) EXPECT_LE(p.mesh.info(v).size, 1.0001 * longest);
}

TEST(BlendAhead, SizesGrowSlowlyFromTheFrontWhereTheTrianglesAreLarger) {
    WithRows p;
    for (const Vertex v : vertices(p.mesh)) {
        if (!p.mesh.info(v).in_row && p.mesh.info(v).kind == NodeKind::interior) p.mesh.info(v).size = 8.0;
    }
    double longest = 0.0;
    double top = 0.0;
    for (const HalfEdge h : front_of_rows(p.mesh)) {
        longest = std::max(longest, p.mesh.length(h));
        top = std::max(top, p.mesh.position(p.mesh.from(h)).y());
    }
    blend_ahead_of_rows(p.mesh, p.reference);
    int ahead = 0;
    for (const Vertex v : vertices(p.mesh)) {
        const double way = p.mesh.position(v).y() - top;
        if (p.mesh.info(v).kind != NodeKind::interior || way < 0.5 || way > 4.0) continue;
        EXPECT_LE(p.mesh.info(v).size, longest + 0.25 * 1.5 * way) << way;
        ++ahead;
    }
    EXPECT_GT(ahead, 10);
}

TEST(BlendAhead, RowsLinesAndWhatIsFarStay) {
    WithRows p;
    const SurfaceMesh before = p.mesh;
    blend_ahead_of_rows(p.mesh, p.reference);
    EXPECT_EQ(quad_count(p.mesh), quad_count(before));
    for (const Vertex v : vertices(before)) {
        const bool fixed = before.info(v).in_row || before.info(v).kind != NodeKind::interior;
        if (!fixed && before.position(v).y() < kNy - 8) continue;
        ASSERT_FALSE(p.mesh.is_deleted(v));
        EXPECT_EQ(p.mesh.position(v), before.position(v));
    }
    for (const Face f : faces(before)) {
        if (!before.is_quad(f)) continue;
        EXPECT_TRUE(p.mesh.is_quad(f));
        EXPECT_EQ(p.mesh.info(f).row, before.info(f).row);
    }
}

TEST(BlendAhead, NothingChangesWithoutRows) {
    Prepared p(shapes::grid(16, 16));
    assign_node_sizes(p.mesh);
    blend_ahead_of_rows(p.mesh, p.reference);
    EXPECT_EQ(to_arrays(p.mesh).points, p.shape.points);
    EXPECT_EQ(p.mesh.face_count(), 512);
}

}  // namespace
}  // namespace anisoquad
