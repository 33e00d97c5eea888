#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Length smoothing: every edge of the node pulls or pushes like a spring whose rest length is the mean length of the node's
/// edges. @returns false at a node without neighbours
bool length_target(const SurfaceMesh& mesh, Vertex v, Point& target);

}  // namespace anisoquad
