#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"
#include "quality/report.h"

namespace anisoquad {

/// Aspect ratio (mean length of the two edges along the source over that of the two side edges) and height (mean length of the
/// side edges) of the quads of every row, found by walking up the columns from the source edges.
/// @param sources tell left from right by the input vertices of the nodes; a side that cannot be told is called "both"
/// @returns rows in the order of source, side, row
std::vector<RowReport> measure_rows(const SurfaceMesh& mesh, std::span<const Source> sources);

}  // namespace anisoquad
