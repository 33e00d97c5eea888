#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Angle-based smoothing @cite zhou2000angle for triangles and quads: at every neighbour the edge to the node is turned onto
/// the bisector of the angle between the edges beside it; the mean of the places so found.
/// @returns false at a boundary node or where an angle is undefined
bool angle_target(const SurfaceMesh& mesh, Vertex v, Point& target);

}  // namespace anisoquad
