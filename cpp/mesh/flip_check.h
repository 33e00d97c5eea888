#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// True if flipping the edge keeps the two triangles on the same side of the surface: the new ones face the way that the old ones
/// face together, and fold no sharper than the old ones unless the cosine between them stays above `least`.
/// @pre both faces at the edge are triangles
bool flip_keeps_surface(const SurfaceMesh& mesh, Edge e, double least);

}  // namespace anisoquad
