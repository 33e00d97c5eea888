#include "mesh/surface_mesh.h"

#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

TEST(SurfaceMesh, TopologyOfKnownSurfaces) {
    EXPECT_EQ(topology(shapes::grid(5, 3).mesh()), (Topology{1, 1, 1}));
    EXPECT_EQ(topology(shapes::grid_with_holes(5, 5, [](int i, int j) { return i != 2 || j != 2; }).mesh()), (Topology{1, 2, 0}));
    EXPECT_EQ(topology(shapes::cylinder(6, 2).mesh()), (Topology{1, 2, 0}));
    EXPECT_EQ(topology(shapes::sphere(6, 4).mesh()), (Topology{1, 0, 2}));
    EXPECT_EQ(topology(shapes::torus(6, 4).mesh()), (Topology{1, 0, 0}));
    EXPECT_EQ(topology(shapes::cube(2).mesh()), (Topology{1, 0, 2}));
    EXPECT_EQ(topology(shapes::joined(shapes::cube(2), shapes::torus(6, 4)).mesh()), (Topology{2, 0, 2}));
}

TEST(SurfaceMesh, CirculatorsVisitEveryEdgeOnceAndTurnTheirWay) {
    const SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    const Vertex center(4);
    std::vector<double> angles;
    for (const HalfEdge h : mesh.outgoing(center)) {
        EXPECT_EQ(mesh.from(h), center);
        EXPECT_EQ(mesh.rotated_ccw(mesh.rotated_cw(h)), h);
        const Point d = mesh.position(mesh.to(h)) - mesh.position(center);
        angles.push_back(std::atan2(d.y(), d.x()));
    }
    EXPECT_EQ(static_cast<int>(angles.size()), mesh.valence(center));
    int rises = 0;  // clockwise: the angle rises only where it wraps
    for (std::size_t i = 0; i < angles.size(); ++i) rises += angles[(i + 1) % angles.size()] > angles[i];
    EXPECT_EQ(rises, 1);
}

TEST(SurfaceMesh, BoundaryLoopsHoldEveryBoundaryEdge) {
    const SurfaceMesh mesh = shapes::cylinder(7, 2).mesh();
    HalfEdge h = mesh.halfedge(Vertex(0));
    ASSERT_TRUE(mesh.is_boundary(h));
    const HalfEdge first = h;
    int n = 0;
    do {
        EXPECT_TRUE(mesh.is_boundary(h));
        EXPECT_EQ(mesh.prev(mesh.next(h)), h);
        h = mesh.next(h);
        ++n;
    } while (h != first);
    EXPECT_EQ(n, 7);
}

TEST(SurfaceMesh, ArraysComeBackAsTheyWere) {
    const shapes::Shape shape = shapes::grid_with_holes(5, 4, [](int i, int j) { return i == 0 || i > 2 || j == 0 || j > 2; });
    const MeshArrays arrays = to_arrays(shape.mesh());
    ASSERT_EQ(arrays.faces.size(), shape.triangles.size());
    for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
        EXPECT_EQ(arrays.face_handles[f], Face(static_cast<std::int32_t>(f)));
        EXPECT_EQ(arrays.faces[f][3], -1);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(arrays.vertices[static_cast<std::size_t>(arrays.faces[f][k])], Vertex(shape.triangles[f][k]));
        }
    }
    EXPECT_LT(arrays.points.size(), shape.points.size());  // the points inside the hole are not written
}

TEST(SurfaceMesh, FindHalfedgeFindsEveryEdgeAndNoOther) {
    for (const shapes::Shape& shape : {shapes::grid(3, 2), shapes::sphere(7, 5), shapes::cylinder(5, 2)}) {
        const SurfaceMesh mesh = shape.mesh();
        for (std::int32_t a = 0; a < mesh.vertex_slots(); ++a) {
            for (std::int32_t b = 0; b < mesh.vertex_slots(); ++b) {
                HalfEdge expected;
                for (const HalfEdge h : mesh.outgoing(Vertex(a))) {
                    if (mesh.to(h) == Vertex(b)) expected = h;
                }
                EXPECT_EQ(mesh.find_halfedge(Vertex(a), Vertex(b)), expected);
            }
        }
    }
}

TEST(SurfaceMesh, FindHalfedgeIsDirected) {
    const SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    const HalfEdge h = mesh.find_halfedge(Vertex(0), Vertex(1));
    ASSERT_TRUE(h.is_valid());
    EXPECT_EQ(mesh.find_halfedge(Vertex(1), Vertex(0)), SurfaceMesh::twin(h));
    EXPECT_FALSE(mesh.find_halfedge(Vertex(0), Vertex(8)).is_valid());
}

}  // namespace
}  // namespace anisoquad
