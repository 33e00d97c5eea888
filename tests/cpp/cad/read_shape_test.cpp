#include "cad/read_shape.h"

#include <gtest/gtest.h>
#include <BRepTools.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Writer.hxx>

#include <fstream>
#include <sstream>

#include "cad_shapes.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

class Files : public testing::Test {
  protected:
    Files()
        : folder_(std::filesystem::temp_directory_path() /
                  ("anisoquad_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Files() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path folder_;
};

TEST(ReadBrep, GivesTheShapeOfAText) {
    std::ostringstream text;
    BRepTools::Write(shapes::stadium().shape(), text);
    const CadShape read(read_brep(text.str()));
    EXPECT_EQ(read.faces().size(), 6u);
    EXPECT_EQ(read.edges().size(), 12u);
}

TEST(ReadBrep, RejectsWhatIsNone) {
    for (const char* text : {"", "not a shape", "DBRep_DrawableShape\n\nCASCADE Topology V1"})
        EXPECT_THROW(read_brep(text), Error) << text;
}

TEST_F(Files, StepIgesAndBrepAreRead) {
    const TopoDS_Shape shape = shapes::stadium().shape();
    STEPControl_Writer step;
    step.Transfer(shape, STEPControl_AsIs);
    ASSERT_EQ(step.Write((folder_ / "a.STEP").c_str()), IFSelect_RetDone);
    IGESControl_Writer iges;
    iges.AddShape(shape);
    ASSERT_TRUE(iges.Write((folder_ / "a.igs").c_str()));
    BRepTools::Write(shape, (folder_ / "a.brep").c_str());
    for (const char* name : {"a.STEP", "a.igs", "a.brep"}) {
        const CadShape read(read_shape(folder_ / name));
        EXPECT_EQ(read.faces().size(), 6u) << name;
        EXPECT_EQ(read.edges().size(), 12u) << name << ": faces share their edges";
        EXPECT_NEAR(read.diagonal(), CadShape(shape).diagonal(), 1e-3) << name;
    }
}

TEST_F(Files, WhatCanNotBeReadIsNamed) {
    std::ofstream(folder_ / "bad.step") << "no STEP";
    std::ofstream(folder_ / "bad.brep") << "no BREP";
    std::ofstream(folder_ / "bad.xyz") << "1 2 3";
    for (const char* name : {"bad.step", "bad.brep", "bad.xyz", "missing.step"}) {
        try {
            read_shape(folder_ / name);
            FAIL() << name << " was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_shape);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace anisoquad::cad
