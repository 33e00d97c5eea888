#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/path_edges.h"

namespace anisoquad::cad {

struct FacetParameters {
    std::vector<std::array<Eigen::Vector2d, 3>> corner;  ///< per triangle: of its corners on its face
    std::vector<Eigen::Vector3d> on_face;                ///< per vertex: the point of one of its faces
    std::vector<double> distance;                        ///< per vertex: from there, the largest over its faces
};

/// Finds the parameters of every triangle's corners on the triangle's face, walking over the triangles of a face from one whose
/// parameters are searched everywhere. The walk does not cross CAD edges, seams among them, so that the corners of a triangle
/// are always on the same side of a seam. At a pole the free parameter is the mean of those of the two other corners.
FacetParameters find_facet_parameters(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles,
                                      std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                      std::span<const std::int32_t> facet_face);

}  // namespace anisoquad::cad
