#pragma once

#include "mesh/surface_mesh.h"
#include "surface/facet_hints.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Makes the quad a, b, c, d (counter-clockwise; h runs a → b) of the unmeshed triangles between its four edges, which must
/// exist; what lies inside is removed, nodes too (Owen 1999, "quad formation").
/// @returns the new face; invalid, and nothing changed, if the four edges do not bound a disk of unmeshed triangles or the
///          quad would be folded (smallest corner below `least` in the plane of the surface normal)
Face form_quad(SurfaceMesh& mesh, HalfEdge h, Vertex c, Vertex d, double least = -0.2);

/// Smoothing after a new quad (paper 2.2, Owen "local smoothing"): Blacker's combination for its nodes on the front, Laplacian
/// for the ring of nodes around it.
/// @param reference surface to which the nodes are brought back; may be null; @param hints facets near the nodes, kept up to date
void smooth_around(SurfaceMesh& mesh, Face quad, const ReferenceSurface* reference, FacetHints& hints);

}  // namespace anisoquad
