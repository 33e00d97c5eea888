#include "features/patches.h"

#include <gtest/gtest.h>

#include "features/feature_lines.h"
#include "shapes.h"

namespace anisoquad {
namespace {

std::int32_t patches_of(SurfaceMesh& mesh, const std::vector<Source>& sources = {}) {
    find_features(mesh, sources, {});
    const std::int32_t patches = find_patches(mesh);
    std::int32_t seen = 0;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const std::int32_t patch = mesh.info(Face(i)).patch;
        EXPECT_GE(patch, 0);
        EXPECT_LE(patch, seen);  // numbered in the order of the faces
        seen = std::max(seen, patch + 1);
    }
    EXPECT_EQ(seen, patches);
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_constrained(Edge(i))) continue;
        EXPECT_EQ(mesh.info(mesh.face(SurfaceMesh::halfedge(Edge(i), 0))).patch,
                  mesh.info(mesh.face(SurfaceMesh::halfedge(Edge(i), 1))).patch);
    }
    return patches;
}

TEST(Patches, AreSeparatedByLines) {
    SurfaceMesh plane = shapes::grid(4, 4).mesh();
    EXPECT_EQ(patches_of(plane), 1);
    SurfaceMesh cube = shapes::cube(3).mesh();
    EXPECT_EQ(patches_of(cube), 6);
    SurfaceMesh sphere = shapes::sphere(24, 16).mesh();
    EXPECT_EQ(patches_of(sphere), 1);
    SurfaceMesh two = shapes::joined(shapes::cube(2), shapes::grid(2, 2)).mesh();
    EXPECT_EQ(patches_of(two), 7);
}

TEST(Patches, ALineThatEndsInsideSeparatesNothing) {
    SurfaceMesh mesh = shapes::grid(4, 4).mesh();
    EXPECT_EQ(patches_of(mesh, {{{10, 11, 12, 13}, {}, Sides::both}}), 1);
    EXPECT_EQ(patches_of(mesh, {{{10, 11, 12, 13, 14}, {}, Sides::both}}), 2);
    EXPECT_EQ(patches_of(mesh, {{{6, 7, 8, 13, 18, 17, 16, 11, 6}, {}, Sides::both}}), 2);
}

}  // namespace
}  // namespace anisoquad
