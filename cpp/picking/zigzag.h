#pragma once

#include <span>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// True when the path turns left and right in turn, as a path of edges over an unstructured triangulation does.
/// @param path neighbours joined by mesh edges
bool is_zigzag(const SurfaceMesh& mesh, std::span<const Vertex> path);

}  // namespace anisoquad
