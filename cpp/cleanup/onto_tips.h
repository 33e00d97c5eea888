#pragma once

#include <cstdint>
#include <span>

#include "features/tips.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Puts a node onto each tip and holds it there as a corner: one of the nearest quad's nodes where that leaves good quads; else
/// a new one with three quads in place of that quad and a neighbour. A tip for which neither leaves upright quads stays as it
/// is.
/// @param tips in the mesh's frame
/// @returns number of tips that got their node
std::int32_t move_onto_tips(SurfaceMesh& mesh, const ReferenceSurface& reference, std::span<const Tip> tips);

}  // namespace anisoquad
