#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/edge_paths.h"
#include "cad/path_edges.h"

namespace anisoquad::cad {

/// The triangles across the three edges of each, from corner k to k+1; -1 = none.
std::vector<std::array<std::int32_t, 3>> facet_neighbours(Triangles triangles);

/// Finds the CAD face of every triangle. Regions are the triangles that paths of border edges separate; a region's face is the
/// one that most of its triangles are known to be of, else one that has all CAD edges round it, the nearest where there are
/// several.
/// @param known per triangle: its CAD face, -1 = not known; empty: of none
/// @throws Error{shape_mismatch} where there is none, Error{face_not_meshable} where a face gets no triangle
std::vector<std::int32_t> find_facet_faces(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles,
                                           std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                           std::span<const EdgePath> paths, std::span<const std::int32_t> known = {});

}  // namespace anisoquad::cad
