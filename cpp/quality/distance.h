#pragma once

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Largest distance of a mesh from a surface, in the units of the points: taken at its nodes, the middles of its edges and the
/// centres of its triangles; a quad counts as the two triangles beside the diagonal from the first node of halfedge(f), as
/// to_arrays() writes it. The larger of both directions is the (sampled) Hausdorff distance.
double distance_to(const ReferenceSurface& surface, const SurfaceMesh& mesh);

}  // namespace anisoquad
