#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Gives every component of triangles that has no front edge (a closed patch without boundary: sphere, torus) a seed: its best
/// pair of triangles becomes a quad. @returns the number of seeds
int start_closed_components(SurfaceMesh& mesh);

}  // namespace anisoquad
