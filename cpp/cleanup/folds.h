#pragma once

#include <span>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Number of edges of the faces, on no line and of no row, whose two quads face away from each other: the mesh turns over there,
/// whatever the surface below it, of which the other side can be near. Edges between a face and one that is not given count
/// or not, but always alike while the edge stays.
int count_folds(const SurfaceMesh& mesh, std::span<const Face> faces);

}  // namespace anisoquad
