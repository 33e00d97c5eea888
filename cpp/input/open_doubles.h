#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// How many vertices of open edges lie at the place of another one, as those along a crack do: two boundaries lie on each other
/// there and the surface is not joined, which is easily overlooked (files that give every face its own vertices).
/// @param mesh triangles fresh from from_arrays()
/// @returns their number, without the first one at each place
std::int32_t count_open_doubles(const SurfaceMesh& mesh);

}  // namespace anisoquad
