#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// The path of mesh edges between two vertices that a user most likely means: shortest (Dijkstra) with lengths that count up to
/// five times less on feature lines and convex ridges, and a little less at the boundary.
/// @returns vertex ids from `from` to `to`; {from} when they are the same; empty when no path joins them
/// @throws Error{index_out_of_range}
std::vector<std::int32_t> best_path(const PickSurface& surface, std::int32_t from, std::int32_t to);

}  // namespace anisoquad
