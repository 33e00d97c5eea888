#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/shape.h"
#include "cad/triangle_origin.h"

namespace anisoquad::cad {

struct TriangulateOptions {
    double deflection = 0.0;  ///< largest distance of the triangles from the shape; 0: a five-thousandth of its diagonal
    double angle = 8.0;       ///< degrees between neighbours along a curve or surface
};

struct Triangulation {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< conforming over the edges that faces share; oriented as the faces
    TriangleOrigin origin = {};
};

/// The shape's faces as triangles, by OpenCASCADE's BRepMesh. Triangles are long and thin, and as large as the limits allow.
/// @throws Error{face_not_meshable} with the CAD faces that get no triangles
Triangulation triangulate(const CadShape& shape, const TriangulateOptions& options = {});

/// True if these are the triangulation's points, to single precision as other programs keep them, and its triangles.
/// @param diagonal of the shape
bool is_same(const Triangulation& made, std::span<const Eigen::Vector3d> points,
             std::span<const std::array<std::int32_t, 3>> triangles, double diagonal);

}  // namespace anisoquad::cad
