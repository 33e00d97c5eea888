#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Largest distance of a triangulation from a surface, in the units of the points: taken at its nodes, the middles of its edges
/// and the centres of its triangles. The larger of both directions is the (sampled) Hausdorff distance.
double distance_to(const ReferenceSurface& surface, std::span<const Point> points,
                   std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace anisoquad
