#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// What the sector at a front node calls for (Owen 1999, "seaming").
enum class SeamKind { none, seam, transition_seam, transition_split };

/// @param h front edge that ends at the node
SeamKind classify_seam(const SurfaceMesh& mesh, HalfEdge h);

/// Merges the two front edges that meet at to(h) at a small angle: their far nodes become one.
/// @returns the merged node; invalid, and no element changed for the worse, if that cannot be done
Vertex seam(SurfaceMesh& mesh, HalfEdge h);

/// Small angle between edges of very different length: the longer one is halved, the quad behind it gives a triangle to the
/// front, and a quad closes the gap. @returns that quad, invalid if it cannot be made
Face transition_seam(SurfaceMesh& mesh, HalfEdge h);

/// Large step of length along the front: the longer edge is halved and the quad behind it gives a triangle back.
/// @returns the new node, invalid if it cannot be made
Vertex transition_split(SurfaceMesh& mesh, HalfEdge h);

}  // namespace anisoquad
