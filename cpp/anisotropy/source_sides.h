#pragma once

#include <span>
#include <vector>

#include "anisotropy/row_stack.h"
#include "options.h"

namespace anisoquad {

/// Empty stacks of rows for the sides of each source with passes (paper 3.1: the source is the initial front). A side that the
/// user left out, or that is the open boundary, has none. Where another constrained line ends on the source, the rows of that
/// side are two stacks, each with an end column along that line.
std::vector<RowStack> source_sides(const SurfaceMesh& mesh, std::span<const Source> sources);

}  // namespace anisoquad
