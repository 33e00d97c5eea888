#pragma once

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Fits the triangles ahead of the rows to the length of the rows' edges, so that the size of elements changes smoothly over the
/// end of the rows (paper 3.2, Fig. 5 shows the sudden transition that is to be avoided): the wanted size of nodes near the
/// front is raised where its edges are long, falling off by a bounded rate with distance, and bounded where they are short,
/// growing with distance; the triangles there are remeshed.
/// @pre assign_node_sizes
/// @throws Error{cancelled}
void blend_ahead_of_rows(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context = no_context());

}  // namespace anisoquad
