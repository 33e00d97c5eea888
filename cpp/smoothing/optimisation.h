#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Moves a node so that the worst element round it gets better: a pattern search in the tangent plane for the largest minimum
/// scaled Jacobian (of inverted elements: the largest minimum of the signed corner areas first), after @cite freitag1997.
/// @param hint as in move_node()
/// @returns true if the node was moved; it may be moved only where move_node() may
bool optimise_node(SurfaceMesh& mesh,
                   Vertex v,
                   const ReferenceSurface* reference = nullptr,
                   std::int32_t* hint = nullptr);

}  // namespace anisoquad
