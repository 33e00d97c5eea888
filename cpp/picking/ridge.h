#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// The line through an edge that a user means when he points at it: its feature line from corner to corner, or, off the feature
/// lines, the ridge of curvature followed both ways while it neither turns sharply nor fades.
/// @param from, to ends of a mesh edge
/// @returns vertex ids, the first also the last when closed; just the edge when there is neither line nor ridge
/// @throws Error{invalid_source} when the two vertices are not joined by an edge
std::vector<std::int32_t> whole_line(const PickSurface& surface, std::int32_t from, std::int32_t to);

/// Lines that look like leading and trailing edges: convex, long and smooth ridges and feature lines off the boundary, the
/// longest first. No two of them run along each other.
/// @returns vertex ids of each, as whole_line() gives them
std::vector<std::vector<std::int32_t>> suggest_lines(const PickSurface& surface);

}  // namespace anisoquad
