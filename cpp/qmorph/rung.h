#pragma once

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// True for a front edge that leads from one line to another over the quad behind it, like the rung of a ladder, and has become
/// too long for the sizes wanted at its ends: where two lines part, the quads between them would get wider and wider. Neither
/// transition of Owen (1999) can halve such an edge, since the quad's sides lie on the lines.
bool is_wide_rung(const SurfaceMesh& mesh, HalfEdge h);

/// Cuts the edge in three, and the quad behind it in four (the template that refines one side of a quad threefold).
/// @param reference surface to which the new nodes are brought; may be null
/// @returns the quad behind the edge's middle third
Face split_rung(SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface* reference);

}  // namespace anisoquad
