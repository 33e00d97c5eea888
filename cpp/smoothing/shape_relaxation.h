#pragma once

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Moves all free nodes with flat stars of quads (FlatStar) at once, sweep after sweep, towards where their quads were
/// rectangles, and not too long ones: each quad asks its nodes to come to the corners of the rectangle nearest to it, each node
/// goes to the mean of what its quads ask for @cite bouaziz2012shapeup, along the surface and with the momentum of its last moves
/// @cite polyak1964some, so that also what is bent over many quads becomes even in a few dozen sweeps. In the end nodes of quads
/// that became poor (Star::kPoor) and poorer than they were go back, half the way or all of it, until there is no such quad.
/// Lines, rows and where the surface turns strongly stay as they are.
/// @returns number of moved nodes
/// @throws Error{cancelled}
int relax_shapes(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context = no_context());

}  // namespace anisoquad
