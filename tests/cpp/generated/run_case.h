#pragma once

#include <string>

#include "generated/mesh_case.h"

namespace anisoquad::generated {

struct Outcome {
    std::string failure;  ///< what must never happen; empty = all is well
    bool meshed = false;
    std::int32_t triangles = 0;
    std::int32_t quads = 0;
    std::int32_t inverted = 0;
};

/// Meshes the case and checks the result. Failures: an error for a valid case, any other exception, an invalid result.
Outcome run_case(const MeshCase& mesh_case);

}  // namespace anisoquad::generated
