#pragma once

#include "context.h"
#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Area of neighbouring quads across the end of the rows, one over the other, beyond which the outer one is changed.
inline constexpr double kMostSizeRatio = 2.0;

/// Moves the nodes of quads beyond the rows' end whose area differs from that of the row's quad beside them by more than
/// kMostSizeRatio, for a solver sees the jump. Elements become no worse than 0.55, or than they were if that is less, in their
/// scaled Jacobian. Nodes of lines slide along them, but not on a target.
/// @returns the number of moves
/// @throws Error{cancelled}
int even_row_ends(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines,
                  const Context& context = no_context());

}  // namespace anisoquad
