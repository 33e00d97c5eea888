#pragma once

#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct OntoTargetResult {
    std::int32_t moved = 0;     ///< nodes
    double largest_move = 0.0;  ///< in mesh units
    std::int32_t inverted = 0;  ///< quads that were upright before, and that nothing keeps upright on the target
};

/// Brings every node that is not at its input place onto the target of the reference surface, in one batch: nodes of feature
/// lines onto what their line's edge lies on, others onto what lies behind the facet near them. Nodes round quads that this
/// turns over are then optimised on the target.
/// @pre reference.target() is set; the input's vertices are on it
/// @param lines in the mesh's frame, lines that EdgeInfo and VertexInfo count
OntoTargetResult move_onto_target(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines);

}  // namespace anisoquad
