#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cad/edge_paths.h"

namespace anisoquad::cad {

/// The mesh vertex at each CAD vertex, -1 = none. Where solids of an assembly touch, several mesh vertices are at one place: each
/// connected piece of the shape belongs to one of the mesh that has a vertex at each of its own.
std::vector<std::int32_t> find_corners(const CadShape& shape, std::span<const Eigen::Vector3d> points,
                                       const Neighbours& neighbours);

}  // namespace anisoquad::cad
