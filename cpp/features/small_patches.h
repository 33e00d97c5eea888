#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Gives patches that are too coarse for quads more nodes on their boundary: a patch of one triangle has its three edges
/// split, so that three quads can fill it. The single split that makes its boundary even would leave it a quad with a flat
/// corner.
/// @pre comes before make_parity_even()
/// @returns the number of edges that were split
std::int32_t refine_small_patches(SurfaceMesh& mesh);

}  // namespace anisoquad
