#include "cleanup/region.h"

#include <gtest/gtest.h>

#include "cleanup/quad_shapes.h"

namespace anisoquad {
namespace {

Region star(const SurfaceMesh& mesh, Vertex v) {
    Region region;
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_boundary(h)) region.faces.push_back(mesh.face(h));
    }
    return region;
}

TEST(Region, OutlineOfAStarHasItsQuadsOnTheLeft) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    RegionEditor editor(mesh);
    Region region = star(mesh, Vertex(12));
    ASSERT_TRUE(editor.find_outline(region));
    EXPECT_EQ(region.loop.size(), 8U);
    EXPECT_EQ(region.inner, std::vector<Vertex>{Vertex(12)});
    for (std::size_t i = 0; i < region.loop.size(); ++i) {
        EXPECT_EQ(mesh.to(region.loop[i]), mesh.from(region.loop[(i + 1) % region.loop.size()]));
    }
}

TEST(Region, FacesAtACutHaveNoOutline) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    RegionEditor editor(mesh);
    const HalfEdge border = mesh.find_halfedge(Vertex(1), Vertex(2));
    Region at_border{{mesh.face(border)}, {}, {}};
    Region beside{{mesh.face(mesh.find_halfedge(Vertex(2), Vertex(3)))}, {}, {}};
    Region away{{mesh.face(mesh.find_halfedge(Vertex(12), Vertex(13)))}, {}, {}};
    for (Region* region : {&at_border, &beside, &away}) EXPECT_TRUE(editor.find_outline(*region));
    mesh.info(SurfaceMesh::edge(border)).cut = true;
    EXPECT_FALSE(editor.find_outline(at_border));
    EXPECT_FALSE(editor.find_outline(beside));  // it has a node of the cut
    EXPECT_TRUE(editor.find_outline(away));
}

TEST(Region, WhatIsNoDiskOrHoldsFixedThingsHasNoOutline) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    RegionEditor editor(mesh);
    Region diagonal{
        {mesh.face(mesh.find_halfedge(Vertex(6), Vertex(7))), mesh.face(mesh.find_halfedge(Vertex(12), Vertex(13)))}, {}, {}};
    EXPECT_FALSE(editor.find_outline(diagonal));
    Region region = star(mesh, Vertex(12));
    mesh.info(Vertex(12)).in_row = true;
    EXPECT_FALSE(editor.find_outline(region));
    mesh.info(Vertex(12)).in_row = false;
    mesh.info(region.faces[0]).row = 1;
    EXPECT_FALSE(editor.find_outline(region));
    mesh.info(region.faces[0]).row = 0;
    mesh.info(SurfaceMesh::edge(mesh.find_halfedge(Vertex(12), Vertex(13)))).line = 3;
    EXPECT_FALSE(editor.find_outline(region));
}

TEST(Region, NoTwoQuadsOnTheSameNodes) {
    // Three quads between two poles are a closed surface: one quad in place of two would lie on the third.
    SurfaceMesh mesh = shapes::quad_mesh({{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}},
                                         {{2, 1, 3, 0}, {3, 1, 4, 0}, {4, 1, 2, 0}});
    RegionEditor editor(mesh);
    const auto face = [&](int from, int to) { return mesh.face(mesh.find_halfedge(Vertex(from), Vertex(to))); };
    Region region{{face(2, 1), face(3, 1)}, {}, {}};
    ASSERT_TRUE(editor.find_outline(region));
    Replacement one;
    one.quads = {{Vertex(0), Vertex(2), Vertex(1), Vertex(4)}};
    EXPECT_FALSE(editor.is_possible(region, one));
    EXPECT_TRUE(editor.is_possible(region, editor.current(region)));
}

TEST(Region, RotatedEdgeAndBack) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    const Topology before = topology(mesh);
    RegionEditor editor(mesh);
    const HalfEdge h = mesh.find_halfedge(Vertex(12), Vertex(13));
    Region region{{mesh.face(h), mesh.face(SurfaceMesh::twin(h))}, {}, {}};
    const std::vector<Face> faces = region.faces;
    ASSERT_TRUE(editor.find_outline(region));
    const Replacement back = editor.current(region);
    Replacement turned;
    turned.quads = {{Vertex(7), Vertex(8), Vertex(13), Vertex(18)}, {Vertex(7), Vertex(18), Vertex(17), Vertex(12)}};
    ASSERT_TRUE(editor.is_possible(region, turned));
    editor.replace(region, turned);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_EQ(topology(mesh), before);
    EXPECT_EQ(mesh.valence(Vertex(7)), 5);
    EXPECT_EQ(mesh.valence(Vertex(12)), 3);
    EXPECT_EQ(mesh.info(region.faces[0]).patch, 0);
    ASSERT_TRUE(editor.is_possible(region, back));
    editor.replace(region, back);
    EXPECT_EQ(region.faces, faces);
    EXPECT_EQ(shapes::defects(mesh), "");
    EXPECT_TRUE(mesh.find_halfedge(Vertex(12), Vertex(13)).is_valid());
    EXPECT_EQ(shapes::irregular_inside(mesh), 0);
}

TEST(Region, ImproperReplacementsAreRefused) {
    SurfaceMesh mesh = shapes::quad_grid(4, 4);
    RegionEditor editor(mesh);
    const HalfEdge h = mesh.find_halfedge(Vertex(12), Vertex(13));
    Region region{{mesh.face(h), mesh.face(SurfaceMesh::twin(h))}, {}, {}};
    ASSERT_TRUE(editor.find_outline(region));
    Replacement twisted;
    twisted.quads = {{Vertex(18), Vertex(13), Vertex(8), Vertex(7)}, {Vertex(7), Vertex(18), Vertex(17), Vertex(12)}};
    EXPECT_FALSE(editor.is_possible(region, twisted));
    Replacement half;
    half.quads = {{Vertex(7), Vertex(8), Vertex(13), Vertex(18)}};
    EXPECT_FALSE(editor.is_possible(region, half));
    Region whole = star(mesh, Vertex(12));
    ASSERT_TRUE(editor.find_outline(whole));
    EXPECT_FALSE(editor.is_possible(whole, twisted)) << "the node in the middle will be gone";
}

}  // namespace
}  // namespace anisoquad
