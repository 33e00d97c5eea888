#pragma once

#include <string>

#include "input/working_input.h"
#include "quad_mesh.h"

namespace anisoquad {

/// The mesh as it is now, in the user's unit.
StageSnapshot snapshot_of(const SurfaceMesh& mesh, const WorkingInput& input, const std::string& name);

}  // namespace anisoquad
