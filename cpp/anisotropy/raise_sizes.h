#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

inline constexpr double kFallOff = 0.64;  ///< of a raised size per unit of way

/// Raises the wanted size of the interior nodes near nodes with long edges, falling off by a bounded rate with distance; never
/// lowers it. Lines, whose nodes are fixed, and rows are not crossed.
/// @param length per vertex: of its long edges, 0 = none
/// @returns per vertex slot 1 where the size was raised
std::vector<char> raise_sizes(SurfaceMesh& mesh, std::span<const double> length);

}  // namespace anisoquad
