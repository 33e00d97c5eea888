#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Isoparametric smoothing @cite blacker1991paving: the mean over the node's quads of what completes the parallelogram,
/// P_j + P_l − P_k with j, l the neighbours and k the opposite node. Triangles don't take part.
/// @returns false at a node without quads
bool isoparametric_target(const SurfaceMesh& mesh, Vertex v, Point& target);

}  // namespace anisoquad
