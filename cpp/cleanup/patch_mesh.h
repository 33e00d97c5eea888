#pragma once

#include <vector>

#include "cleanup/patch_plan.h"
#include "cleanup/region.h"

namespace anisoquad {

/// The quads of a planned patch.
/// @param sides nodes of each side from corner to corner, counter-clockwise, both corners included
/// @param size VertexInfo::size of the new nodes
Replacement mesh_patch(const SurfaceMesh& mesh, PatchPlanner& planner, std::vector<std::vector<Vertex>> sides, int budget,
                       double size);

}  // namespace anisoquad
