#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Makes an edge between two nodes of the unmeshed triangles by swapping the edges that the straight line between them crosses
/// (the queue of Owen 1999, section "top edge recovery"; on a curved surface in the mean plane of the crossed triangles).
/// @returns the half-edge a → b; invalid if the line crosses a front or constrained edge, or the swaps do not come to an end.
///          Swaps that were made until then stay: they never invert a triangle.
HalfEdge recover_edge(SurfaceMesh& mesh, Vertex a, Vertex b);

}  // namespace anisoquad
