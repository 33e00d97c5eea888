#include "cad/shape.h"

#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>

#include "cad_shapes.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

TEST(CadShape, NumbersFacesEdgesAndVertices) {
    const CadShape box = shapes::box();
    EXPECT_EQ(box.faces().size(), 6u);
    EXPECT_EQ(box.edges().size(), 12u);
    EXPECT_EQ(box.vertices().size(), 8u);
    EXPECT_NEAR(box.diagonal(), std::sqrt(14.0), 1e-9);
    for (const CadFace& face : box.faces()) EXPECT_EQ(face.edges.size(), 4u);
    for (const CadEdge& edge : box.edges()) {
        EXPECT_EQ(edge.faces.size(), 2u);
        EXPECT_TRUE(edge.is_border());
        const Eigen::Vector3d way = box.vertex(edge.vertex[1]) - box.vertex(edge.vertex[0]);
        EXPECT_NEAR(way.norm(), edge.length, 1e-9);
    }
}

TEST(CadShape, KnowsSeamsAndPoles) {
    const CadShape sphere = shapes::sphere();
    ASSERT_EQ(sphere.edges().size(), 3u);
    int poles = 0, seams = 0;
    for (const CadEdge& edge : sphere.edges()) {
        poles += edge.is_degenerated();
        seams += edge.seam;
        EXPECT_FALSE(edge.is_border());
    }
    EXPECT_EQ(poles, 2);
    EXPECT_EQ(seams, 1);
    const CadFace& face = sphere.face(0);
    EXPECT_TRUE(face.range[0].periodic);
    EXPECT_FALSE(face.range[1].closed);
}

TEST(CadShape, RejectsWhatHasNoFaces) {
    TopoDS_Compound empty;
    BRep_Builder().MakeCompound(empty);
    for (const TopoDS_Shape& shape : {TopoDS_Shape(), TopoDS_Shape(empty)}) {
        try {
            const CadShape made(shape, "Nothing");
            FAIL() << "an empty shape was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_shape);
            EXPECT_NE(std::string(error.what()).find("Nothing"), std::string::npos);
        }
    }
}

TEST(CheckShape, NamesInvalidFaces) {
    EXPECT_NO_THROW(check_shape(shapes::box()));
    EXPECT_TRUE(invalid_faces(shapes::box()).empty());
    // A wire whose edges cross each other bounds no face.
    BRepBuilderAPI_MakeWire wire;
    const gp_Pnt a(0, 0, 0), b(1, 1, 0), c(1, 0, 0), d(0, 1, 0);
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, d}, std::pair{d, a}})
        wire.Add(BRepBuilderAPI_MakeEdge(from, to));
    const CadShape bow(BRepBuilderAPI_MakeFace(wire.Wire()).Shape(), "Bow");
    try {
        check_shape(bow);
        FAIL() << "a face with a crossing outline was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_shape);
        EXPECT_EQ(error.kind(), ElementKind::cad_face);
        EXPECT_EQ(error.ids(), std::vector<std::int32_t>{0});
        EXPECT_NE(std::string(error.what()).find("Face1"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("repair"), std::string::npos);
    }
}

TEST(CadEdge, ASeamIsABorderWhereAnotherFaceEnds) {
    const CadShape cylinder = shapes::cylinder();
    const auto seam = std::ranges::find_if(cylinder.edges(), [](const CadEdge& e) { return e.seam; });
    ASSERT_NE(seam, cylinder.edges().end());
    EXPECT_FALSE(seam->is_border());
    CadEdge shared = *seam;
    shared.faces.push_back(1);
    EXPECT_TRUE(shared.is_border());
}

}  // namespace
}  // namespace anisoquad::cad
