#pragma once

#include "input/working_input.h"
#include "quad_mesh.h"

namespace anisoquad {

/// Writes the finished mesh into the result's arrays, in the user's unit and with the user's vertex ids.
/// @param input whose points the mesh was made of
void collect_result(const SurfaceMesh& mesh, const WorkingInput& input, QuadMeshResult& result);

}  // namespace anisoquad
