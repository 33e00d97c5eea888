#pragma once

#include "features/reference_lines.h"
#include "quad_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// For each quad and line edge the input's element near its middle, in the order of collect_result().
void find_nearest_input(const SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines,
                        QuadMeshResult& result);

}  // namespace anisoquad
