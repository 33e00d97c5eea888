#pragma once

#include <cstdint>
#include <span>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "options.h"
#include "quality/report.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Measures the result and fills the report's figures: counts of elements, topology, quality, rows, distance. Those that only
/// the stages know (patches, feature lines, parity splits, passes, times, warnings) are left alone.
///
/// Quads are numbered (Distribution::worst) as to_arrays() writes faces. Triangles that are left are counted, and left out of
/// the quality measures. Percentiles interpolate linearly between the sorted values.
/// @param reference the triangulation that was meshed, in the frame and units of `result`
/// @param euler_in its Euler characteristic
/// @param sources tell the left from the right side of the rows
/// @param context told between the measures. @throws Error{cancelled}
void measure(const SurfaceMesh& result, const ReferenceSurface& reference, std::int32_t euler_in, Report& report,
             std::span<const Source> sources = {}, const Context& context = no_context());

}  // namespace anisoquad
