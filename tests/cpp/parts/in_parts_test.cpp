#include "parts/in_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cleanup/cleanup.h"
#include "parallel.h"
#include "qmorph/front.h"
#include "qmorph/qmorph.h"
#include "stages.h"

namespace anisoquad {
namespace {

using stages::Prepared;

constexpr std::int32_t kSmall = 2000;

struct Counts {
    std::int32_t parts = 0;
    std::int32_t left = 0;
    CleanupResult cleaned;
};

/// Nodes inside moved to and fro in the plane.
shapes::Shape uneven(shapes::Shape shape) {
    const SurfaceMesh mesh = shape.mesh();
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const auto n = static_cast<double>(i);
        if (!mesh.is_boundary(Vertex(static_cast<std::int32_t>(i))))
            shape.points[i] += 0.25 * Point(std::sin(1.7 * n * n), std::sin(2.3 * n * n + 1.0), 0.0);
    }
    return shape;
}

/// Fill and clean-up in small parts, and then of what they left near the cuts.
Counts mesh_in_parts(Prepared& p) {
    Counts counts;
    const Partition fill = make_partition(
        p.mesh, [&](Face f) { return touches_front(p.mesh, f); }, no_context(), kSmall);
    counts.parts = fill.parts;
    in_parts(p.mesh, fill, no_context(),
             [&](SurfaceMesh& part, const Cuts& cuts, Context& own) { fill_with_quads(part, &p.reference, own, cuts); });
    if (!fill.all_cuts.empty()) counts.left = fill_with_quads(p.mesh, &p.reference).left;
    EXPECT_TRUE(validate(p.mesh).empty());
    const Partition clean = make_partition(
        p.mesh, [](Face) { return true; }, no_context(), kSmall);
    in_parts(p.mesh, clean, no_context(),
             [&](SurfaceMesh& part, const Cuts&, Context& own) { clean_up(part, p.reference, own); });
    counts.cleaned = clean_up_near(clean.all_cuts, p.mesh, p.reference);
    EXPECT_TRUE(validate(p.mesh).empty());
    EXPECT_EQ(topology(p.mesh), p.before);
    return counts;
}

TEST(InParts, ARegularGridIsMeshedAsIfThereWereNoCuts) {
    Prepared p(shapes::grid(80, 40));
    const Counts counts = mesh_in_parts(p);
    EXPECT_EQ(counts.parts, 4);
    EXPECT_EQ(counts.left, 0);
    EXPECT_EQ(p.mesh.face_count(), 80 * 40);
    EXPECT_EQ(counts.cleaned.irregular_after, 0);
}

TEST(InParts, ACutPatchIsAsRegularAsAWholeOne) {
    const shapes::Shape shape = uneven(shapes::grid(80, 40));
    Prepared whole(shape);
    fill_with_quads(whole.mesh, &whole.reference);
    const CleanupResult cleaned = clean_up(whole.mesh, whole.reference);
    Prepared p(shape);
    const Counts counts = mesh_in_parts(p);
    EXPECT_GE(counts.parts, 2);
    EXPECT_EQ(counts.left, 0);
    EXPECT_LE(counts.cleaned.irregular_after, cleaned.irregular_after + 4);
}

TEST(InParts, TheResultIsTheSameForAnyNumberOfThreads) {
    const shapes::Shape shape = uneven(shapes::grid(70, 50));
    std::vector<MeshArrays> results;
    for (const int threads : {1, 2, 3}) {
        Prepared p(shape);
        with_threads(threads, [&] { mesh_in_parts(p); });
        results.push_back(to_arrays(p.mesh));
    }
    for (const MeshArrays& result : results) {
        EXPECT_EQ(result.points, results[0].points);
        EXPECT_EQ(result.faces, results[0].faces);
    }
}

}  // namespace
}  // namespace anisoquad
