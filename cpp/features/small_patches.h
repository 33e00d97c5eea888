#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Fills patches that are too coarse for a good quad with three quads a triangle, round the triangle's middle and those of its
/// edges: patches of one triangle, which the single split that makes their boundary even would leave a quad with a flat corner,
/// patches of two triangles that make no convex quad, and tetrahedra, whose pairs of triangles would lie on each other.
/// @pre comes before make_parity_even()
/// @returns the number of edges that were split
std::int32_t refine_small_patches(SurfaceMesh& mesh);

}  // namespace anisoquad
