#include "parts/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "qmorph/front.h"
#include "shapes.h"

namespace anisoquad {
namespace {

SurfaceMesh prepared(const shapes::Shape& shape) {
    SurfaceMesh mesh = shape.mesh();
    find_features(mesh, {}, {});
    find_patches(mesh);
    return mesh;
}

Partition by_front(const SurfaceMesh& mesh, std::int32_t most) {
    return make_partition(
        mesh, [&](Face f) { return touches_front(mesh, f); }, no_context(), most);
}

std::vector<std::int32_t> face_counts(const Partition& partition) {
    std::vector<std::int32_t> counts(static_cast<std::size_t>(partition.parts), 0);
    for (const std::int32_t p : partition.part_of_face) ++counts.at(static_cast<std::size_t>(p));
    return counts;
}

TEST(Partition, LeavesWhatIsSmallInOnePart) {
    const SurfaceMesh cube = prepared(shapes::cube(3));
    const Partition all = by_front(cube, 200);
    EXPECT_EQ(face_counts(all), std::vector<std::int32_t>{108});
    EXPECT_TRUE(all.all_cuts.empty());
}

TEST(Partition, CutsThroughAllPatches) {
    const SurfaceMesh cube = prepared(shapes::cube(4));  // six patches
    const Partition halves = by_front(cube, 100);
    EXPECT_EQ(face_counts(halves), (std::vector<std::int32_t>{96, 96}));
    std::set<std::int32_t> patches;
    for (std::int32_t f = 0; f < cube.face_slots(); ++f) {
        if (halves.part_of_face[static_cast<std::size_t>(f)] == 0) patches.insert(cube.info(Face(f)).patch);
    }
    EXPECT_EQ(patches.size(), 5U);
}

TEST(Partition, CutsAcrossTheLongestExtent) {
    const SurfaceMesh plate = prepared(shapes::grid(20, 8));
    const Partition halves = by_front(plate, 200);
    EXPECT_EQ(face_counts(halves), (std::vector<std::int32_t>{160, 160}));
    ASSERT_EQ(halves.cuts.size(), 2U);
    for (const Cuts& cuts : {halves.cuts[0], halves.cuts[1], halves.all_cuts}) {
        EXPECT_TRUE(cuts.is_near({10.0, 4.0, 0.0}, 0.5));
        EXPECT_FALSE(cuts.is_near({5.0, 4.0, 0.0}, 2.0));
    }
    const Partition quarters = by_front(plate, 100);
    EXPECT_EQ(face_counts(quarters), (std::vector<std::int32_t>{80, 80, 80, 80}));
    EXPECT_TRUE(quarters.cuts[0].is_near({5.0, 4.0, 0.0}, 0.5));
    EXPECT_FALSE(quarters.cuts[3].is_near({5.0, 4.0, 0.0}, 2.0));
    EXPECT_TRUE(quarters.all_cuts.is_near({15.0, 4.0, 0.0}, 0.5));
}

TEST(Partition, DoesNotCutWhereOneHalfHasNothingToStartFrom) {
    const SurfaceMesh sphere = prepared(shapes::sphere(24, 16));
    const Partition whole = by_front(sphere, 100);
    EXPECT_EQ(whole.parts, 1);
    EXPECT_TRUE(whole.all_cuts.empty());
    const Partition cut = make_partition(
        sphere, [](Face) { return true; }, no_context(), 400);
    EXPECT_EQ(cut.parts, 2);
}

TEST(Partition, OfNothingHasNoParts) {
    SurfaceMesh mesh;
    const Partition nothing = by_front(mesh, 100);
    EXPECT_EQ(nothing.parts, 0);
}

}  // namespace
}  // namespace anisoquad
