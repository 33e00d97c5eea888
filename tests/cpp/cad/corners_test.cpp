#include "cad/corners.h"

#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>

#include "cad/link_mesh.h"
#include "cad/triangulate.h"
#include "cad_shapes.h"

namespace anisoquad::cad {
namespace {

TopoDS_Shape box_at(const gp_Pnt& corner, double x, double y, double z) { return BRepPrimAPI_MakeBox(corner, x, y, z).Shape(); }

CadShape compound(const std::vector<TopoDS_Shape>& parts) {
    TopoDS_Compound whole;
    const BRep_Builder builder;
    builder.MakeCompound(whole);
    for (const TopoDS_Shape& part : parts) builder.Add(whole, part);
    return CadShape(whole, "Assembly");
}

std::vector<std::int32_t> corners_of(const CadShape& shape, const Triangulation& mesh) {
    return find_corners(shape, mesh.points, Neighbours(mesh.points.size(), mesh.triangles));
}

TEST(Corners, AreTheMeshVerticesAtTheCadVertices) {
    const CadShape box = shapes::box();
    const Triangulation mesh = triangulate(box);
    const std::vector<std::int32_t> corners = corners_of(box, mesh);
    ASSERT_EQ(corners.size(), 8u);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        ASSERT_GE(corners[i], 0);
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(corners[i])], box.vertices()[i]);
    }
}

TEST(Corners, AreMissingWhereTheMeshHasNone) {
    for (const std::int32_t corner : corners_of(shapes::box(), triangulate(shapes::sphere(1.5)))) EXPECT_EQ(corner, -1);
}

TEST(Corners, OfSolidsThatTouchAreEachOnItsOwnMesh) {
    // Two boxes with a common side face, none of whose vertices, edges and faces are shared.
    const CadShape shape = compound({box_at(gp_Pnt(0, 0, 0), 1, 1, 1), box_at(gp_Pnt(1, 0, 0), 2, 1, 1)});
    std::vector<std::int32_t> corners = corners_of(shape, triangulate(shape));
    ASSERT_EQ(corners.size(), 16u);
    std::sort(corners.begin(), corners.end());
    EXPECT_GE(corners.front(), 0);
    EXPECT_EQ(std::unique(corners.begin(), corners.end()), corners.end());
}

TEST(Corners, OfAPinThatFillsAHoleAreNotThoseOfTheHole) {
    // The pin's vertices are all among those of the frame round it, which comes first or last.
    const std::vector<TopoDS_Shape> frame{BRepPrimAPI_MakePrism(
                                              [] {
                                                  const auto square = [](double low, double high) {
                                                      const gp_Pnt a(low, low, 0), b(high, low, 0), c(high, high, 0),
                                                          d(low, high, 0);
                                                      BRepBuilderAPI_MakeWire wire;
                                                      for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
                                                          wire.Add(BRepBuilderAPI_MakeEdge(p, q));
                                                      return wire.Wire();
                                                  };
                                                  BRepBuilderAPI_MakeFace face(square(0, 3));
                                                  face.Add(TopoDS::Wire(square(1, 2).Reversed()));
                                                  return face.Face();
                                              }(),
                                              gp_Vec(0, 0, 1))
                                              .Shape()};
    const TopoDS_Shape pin = box_at(gp_Pnt(1, 1, 0), 1, 1, 1);
    for (const auto& parts : {std::vector{frame[0], pin}, std::vector{pin, frame[0]}}) {
        const CadShape shape = compound(parts);
        const Triangulation mesh = triangulate(shape);
        std::vector<std::int32_t> corners = corners_of(shape, mesh);
        ASSERT_EQ(corners.size(), 24u);
        std::sort(corners.begin(), corners.end());
        EXPECT_EQ(std::unique(corners.begin(), corners.end()), corners.end());
        const MeshLink link = link_mesh(shape, mesh.points, mesh.triangles, {});
        EXPECT_EQ(*std::max_element(link.facet_face.begin(), link.facet_face.end()), 15);
    }
}

}  // namespace
}  // namespace anisoquad::cad
