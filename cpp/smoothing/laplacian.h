#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Length-weighted Laplacian smoothing @cite owen1999qmorph: the mean of the neighbours, each weighted by the length of its
/// edge. @returns false (target unchanged) at a node without neighbours
bool laplacian_target(const SurfaceMesh& mesh, Vertex v, Point& target);

}  // namespace anisoquad
