#pragma once

#include "mesh/surface_mesh.h"
#include "prepare/coverage.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// True if the triangles round from(h) keep their side, a usable shape and their place on the surface, and do not become too long
/// (for VertexInfo::size), when the node is merged into to(h), and no two lines become one.
/// @param deviation of a triangle's middle and edges from the surface that passes in any case
/// @pre all faces at from(h) are triangles
bool may_collapse(const SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface& reference, double deviation);

/// Merges from(h) into to(h) if that may be done and, where a coverage is given, leaves nothing uncovered.
/// @returns true if it was done
bool try_collapse(SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface& reference, double deviation, Coverage* coverage);

/// Splits an edge between triangles, with the new node at p.
Vertex split_covered_edge(SurfaceMesh& mesh, Edge e, const Point& p, Coverage* coverage);

}  // namespace anisoquad
