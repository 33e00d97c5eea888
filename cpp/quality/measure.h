#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mesh/surface_mesh.h"
#include "quality/report.h"

namespace anisoquad {

/// Measures the result and fills the report's figures on quality, topology, rows and distance; counts of stages, passes, times
/// and warnings are left alone.
///
/// Quads are numbered (Distribution::worst) as to_arrays() writes faces. Triangles that are left are counted, and left out of
/// the quality measures. Distances are taken at nodes, middles of edges and centres of faces, both ways.
/// @param input_triangles the triangulation that was meshed, checked by check_input()
void measure(const SurfaceMesh& result,
             std::span<const Point> input_points,
             std::span<const std::array<std::int32_t, 3>> input_triangles,
             Report& report);

}  // namespace anisoquad
