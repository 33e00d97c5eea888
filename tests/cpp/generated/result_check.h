#pragma once

#include <string>
#include <vector>

#include "generated/mesh_case.h"

namespace anisoquad::generated {

/// What must hold for the mesh of any valid surface, computed from the arrays alone: all quads, conforming, oriented, the same
/// components, boundary loops and Euler characteristic, boundary and feature lines covered, finite points.
/// @param surface the surface that was meshed (of a repaired case: the mended one)
/// @returns one line per defect; empty = valid
std::vector<std::string> defects(const MeshCase& surface, const QuadMeshResult& result);

}  // namespace anisoquad::generated
