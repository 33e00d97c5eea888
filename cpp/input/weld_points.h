#pragma once

#include <cstdint>
#include <vector>

#include "input/triangle_soup.h"

namespace anisoquad {

/// For every vertex the lowest vertex at its place, itself if it is the only one. Two vertices are at one place when they are
/// no further apart than 1e-7 of the model's diagonal and a twentieth of the model's typical and their own shortest edge.
/// @pre the facets' indices are in range and their vertices finite
std::vector<std::int32_t> points_at_one_place(const TriangleSoup& soup);

/// Merges vertices at one place where the surface is open: ends of edges with a single facet, as every edge of a triangle
/// soup is. Closed surfaces that only touch each other stay apart.
/// @param place from points_at_one_place(); @returns the number of vertices that went into others
std::int32_t weld_open_edges(TriangleSoup& soup, std::span<const std::int32_t> place);

}  // namespace anisoquad
