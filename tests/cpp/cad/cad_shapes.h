#pragma once

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <memory>

#include "cad/shape.h"

/// Shapes for tests, in the user's unit.
namespace anisoquad::cad::shapes {

inline CadShape box(double x = 3.0, double y = 2.0, double z = 1.0) {
    return CadShape(BRepPrimAPI_MakeBox(x, y, z).Shape(), "Box");
}
/// A box of six faces that share no edges, as IGES files often have them.
inline CadShape loose_box() {
    TopoDS_Compound faces;
    BRep_Builder builder;
    builder.MakeCompound(faces);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(3.0, 2.0, 1.0).Shape();
    for (TopExp_Explorer e(box, TopAbs_FACE); e.More(); e.Next()) builder.Add(faces, BRepBuilderAPI_Copy(e.Current()).Shape());
    return CadShape(faces, "Loose box");
}
inline CadShape cylinder(double radius = 1.0, double height = 2.0) {
    return CadShape(BRepPrimAPI_MakeCylinder(radius, height).Shape(), "Cylinder");
}
inline CadShape sphere(double radius = 1.0) { return CadShape(BRepPrimAPI_MakeSphere(radius).Shape(), "Sphere"); }
inline CadShape torus(double large = 3.0, double small = 1.0) {
    return CadShape(BRepPrimAPI_MakeTorus(large, small).Shape(), "Torus");
}
inline CadShape cone() { return CadShape(BRepPrimAPI_MakeCone(1.0, 0.0, 2.0).Shape(), "Cone"); }

/// A plate with two straight sides and two round ends: its sides go on into each other smoothly.
inline CadShape stadium() {
    const gp_Pnt a(0, 0, 0), b(4, 0, 0), c(4, 2, 0), d(0, 2, 0);
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(a, b));
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, gp_Pnt(5, 1, 0), c).Value()));
    wire.Add(BRepBuilderAPI_MakeEdge(c, d));
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(d, gp_Pnt(-1, 1, 0), a).Value()));
    return CadShape(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 1)).Shape(), "Stadium");
}

/// A wavy free-form face over the square 0…4.
inline CadShape wavy() {
    TColgp_Array2OfPnt points(1, 9, 1, 9);
    for (int i = 1; i <= 9; ++i) {
        for (int k = 1; k <= 9; ++k)
            points(i, k) = gp_Pnt(0.5 * (i - 1), 0.5 * (k - 1), 0.4 * std::sin(0.9 * i) * std::cos(0.7 * k));
    }
    return CadShape(BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-6).Shape(), "Wavy");
}

/// Index of the first edge that has the given length.
inline std::int32_t edge_of_length(const CadShape& shape, double length) {
    for (std::size_t i = 0; i < shape.edges().size(); ++i) {
        if (std::abs(shape.edges()[i].length - length) < 1e-6) return static_cast<std::int32_t>(i);
    }
    return -1;
}

}  // namespace anisoquad::cad::shapes
