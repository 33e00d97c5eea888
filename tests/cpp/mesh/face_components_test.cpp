#include "mesh/face_components.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace anisoquad {
namespace {

const auto any = [](auto) { return true; };

TEST(FaceComponents, AConnectedMeshIsOne) {
    const SurfaceMesh mesh = shapes::grid(4, 3).mesh();
    const FaceComponents found = face_components(mesh, any, any);
    EXPECT_EQ(found.count(), 1);
    EXPECT_EQ(found.first, std::vector<Face>{Face(0)});
    for (const std::int32_t component : found.of_face) EXPECT_EQ(component, 0);
}

TEST(FaceComponents, WithoutJoiningEdgesEachFaceIsOneInItsOrder) {
    const SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    const FaceComponents found = face_components(mesh, any, [](Edge) { return false; });
    ASSERT_EQ(found.count(), mesh.face_count());
    for (std::int32_t f = 0; f < found.count(); ++f) {
        EXPECT_EQ(found.of_face[static_cast<std::size_t>(f)], f);
        EXPECT_EQ(found.first[static_cast<std::size_t>(f)], Face(f));
    }
}

TEST(FaceComponents, FacesThatDoNotCountSeparateTheOthers) {
    // The middle one of three columns of cells is left out.
    const SurfaceMesh mesh = shapes::grid(3, 2).mesh();
    const auto x = [&](Face f) {
        double sum = 0.0;
        for (const HalfEdge h : mesh.halfedges(f)) sum += mesh.position(mesh.from(h)).x() / 3.0;
        return sum;
    };
    double width = 0.0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) width = std::max(width, mesh.position(Vertex(i)).x());
    const auto counts = [&](Face f) { return x(f) < width / 3.0 || x(f) > 2.0 * width / 3.0; };
    const FaceComponents found = face_components(mesh, counts, any);
    ASSERT_EQ(found.count(), 2);
    EXPECT_LT(found.first[0], found.first[1]);
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
        const std::int32_t component = found.of_face[static_cast<std::size_t>(f)];
        ASSERT_EQ(component >= 0, counts(Face(f)));
        if (component < 0) continue;
        const Face first = found.first[static_cast<std::size_t>(component)];
        EXPECT_EQ(x(Face(f)) < 0.5 * width, x(first) < 0.5 * width);
        EXPECT_LE(first, Face(f));
    }
}

TEST(FaceComponents, DeletedFacesBelongToNone) {
    SurfaceMesh mesh = shapes::grid(2, 1).mesh();
    mesh.remove(Face(1));
    const FaceComponents found = face_components(mesh, any, [](Edge) { return false; });
    EXPECT_EQ(found.of_face[1], -1);
    EXPECT_EQ(found.count(), mesh.face_count());
}

}  // namespace
}  // namespace anisoquad
