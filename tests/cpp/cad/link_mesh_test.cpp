#include "cad/link_mesh.h"

#include <gtest/gtest.h>

#include "cad/closest_point.h"
#include "cad/triangulate.h"
#include "cad_shapes.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

Vector3d value(const CadFace& face, const Eigen::Vector2d& x) {
    const gp_Pnt p = face.surface->Value(x[0], x[1]);
    return {p.X(), p.Y(), p.Z()};
}

TEST(LinkMesh, EveryTriangleIsOnItsFaceAndHasItsParameters) {
    for (const CadShape& shape : {shapes::box(), shapes::cylinder(), shapes::sphere(), shapes::cone(), shapes::torus(),
                                  shapes::stadium(), shapes::wavy()}) {
        const Triangulation mesh = triangulate(shape);
        const MeshLink link = link_mesh(shape, mesh.points, mesh.triangles);
        ASSERT_EQ(link.facet_face.size(), mesh.triangles.size());
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            const CadFace& face = shape.face(link.facet_face[f]);
            Vector3d middle = Vector3d::Zero();
            Eigen::Vector2d parameter = Eigen::Vector2d::Zero();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector3d& p = link.points[static_cast<std::size_t>(mesh.triangles[f][k])];
                EXPECT_LT((value(face, link.facet_parameter[f][k]) - p).norm(), 1e-6 * shape.diagonal()) << shape.name();
                middle += p / 3.0;
                parameter += link.facet_parameter[f][k] / 3.0;
            }
            // No triangle reaches over a seam in the plane of the parameters: its middle is there where it is in space.
            EXPECT_LT((value(face, parameter) - middle).norm(), 0.1 * shape.diagonal()) << shape.name();
            EXPECT_LT(closest_on_face(face, middle, parameter).distance, 2e-3 * shape.diagonal()) << shape.name();
        }
    }
}

TEST(LinkMesh, WhatIsKnownOfTheTrianglesIsWhatTheSearchFinds) {
    for (const CadShape& shape : {shapes::box(), shapes::cylinder(), shapes::sphere(), shapes::cone(), shapes::torus(),
                                  shapes::stadium(), shapes::loose_box()}) {
        const Triangulation mesh = triangulate(shape);
        const MeshLink found = link_mesh(shape, mesh.points, mesh.triangles);
        const MeshLink known = link_mesh(shape, mesh.points, mesh.triangles, mesh.origin);
        EXPECT_EQ(known.facet_face, found.facet_face) << shape.name();
        for (std::size_t e = 0; e < found.paths.size(); ++e)
            EXPECT_EQ(known.paths[e].vertices, found.paths[e].vertices) << shape.name() << e;
        for (std::size_t v = 0; v < found.entity.size(); ++v)
            EXPECT_EQ(known.entity[v].kind, found.entity[v].kind) << shape.name() << v;
    }
}

TEST(LinkMesh, WhatIsKnownGoesBeforeWhatTheSearchWouldFind) {
    const CadShape box = shapes::box();
    const Triangulation mesh = triangulate(box);
    TriangleOrigin other = mesh.origin;
    for (std::int32_t& face : other.facet_face) face = face == 0 ? 1 : face == 1 ? 0 : face;  // two opposite sides
    EXPECT_THROW(link_mesh(box, mesh.points, mesh.triangles, other), Error) << "the points are not on the faces given";
    other = mesh.origin;
    other.facet_face.assign(other.facet_face.size(), -1);
    other.paths.assign(other.paths.size(), {});
    EXPECT_EQ(link_mesh(box, mesh.points, mesh.triangles, other).facet_face, mesh.origin.facet_face);
}

TEST(LinkMesh, TellsVerticesEdgesAndFaces) {
    const CadShape box = shapes::box();
    const Triangulation mesh = triangulate(box);
    const MeshLink link = link_mesh(box, mesh.points, mesh.triangles);
    ASSERT_EQ(link.entity.size(), 8u);
    for (std::size_t v = 0; v < 8; ++v) {
        EXPECT_EQ(link.entity[v].kind, EntityKind::vertex);
        EXPECT_LT((box.vertex(link.entity[v].index) - mesh.points[v]).norm(), 1e-12);
    }
}

TEST(LinkMesh, PutsPointsOfSinglePrecisionOntoTheShape) {
    const CadShape cylinder = shapes::cylinder(1.0, 2.0);
    Triangulation mesh = triangulate(cylinder);
    for (Vector3d& p : mesh.points) p = p.cast<float>().cast<double>();
    const MeshLink link = link_mesh(cylinder, mesh.points, mesh.triangles);
    double before = 0.0;
    double after = 0.0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (link.entity[v].kind == EntityKind::vertex) continue;
        before = std::max(before, std::abs(mesh.points[v].head<2>().norm() - 1.0));
        after = std::max(after, std::abs(link.points[v].head<2>().norm() - 1.0));
    }
    EXPECT_GT(before, 1e-9);
    EXPECT_LT(after, 1e-14);
}

ErrorCode code_of(const CadShape& shape, const Triangulation& mesh, ElementKind kind, std::string& message) {
    try {
        link_mesh(shape, mesh.points, mesh.triangles);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind);
        EXPECT_FALSE(error.ids().empty());
        message = error.what();
        return error.code();
    }
    ADD_FAILURE() << "they were taken for each other's";
    return ErrorCode::cancelled;
}

TEST(LinkMesh, RejectsWhatDoesNotBelongTogether) {
    std::string message;
    EXPECT_EQ(code_of(shapes::box(), triangulate(shapes::stadium()), ElementKind::cad_edge, message), ErrorCode::shape_mismatch);
    EXPECT_NE(message.find("Edge1"), std::string::npos);
    EXPECT_NE(message.find("Box"), std::string::npos);
    EXPECT_EQ(code_of(shapes::sphere(), triangulate(shapes::torus()), ElementKind::vertex, message), ErrorCode::shape_mismatch);
}

TEST(LinkMesh, NamesFacesWithoutTriangles) {
    const CadShape box = shapes::box();
    Triangulation mesh = triangulate(box);
    const MeshLink link = link_mesh(box, mesh.points, mesh.triangles);
    Triangulation open{mesh.points, {}};
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        if (link.facet_face[f] != 2) open.triangles.push_back(mesh.triangles[f]);
    }
    std::string message;
    EXPECT_EQ(code_of(box, open, ElementKind::cad_face, message), ErrorCode::face_not_meshable);
    EXPECT_NE(message.find("Face3"), std::string::npos);
}

TEST(LinkMesh, RejectsBadTriangles) {
    const CadShape box = shapes::box();
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 7}};
    EXPECT_THROW(link_mesh(box, points, triangles), Error);
}

}  // namespace
}  // namespace anisoquad::cad
