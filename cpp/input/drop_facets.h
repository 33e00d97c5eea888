#pragma once

#include <cstdint>

#include "input/triangle_soup.h"

/// Steps of the repair that remove facets; each returns how many.
namespace anisoquad {

/// Facets that name a vertex that does not exist.
std::int32_t drop_out_of_range(TriangleSoup& soup);
/// Facets at a vertex with a coordinate that is not finite. @pre indices in range
std::int32_t drop_non_finite(TriangleSoup& soup);
/// Facets that name a vertex twice.
std::int32_t drop_repeated_corners(TriangleSoup& soup);
/// All but the first of the facets that have the same three corners, turned either way. @pre no repeated corners
std::int32_t drop_duplicates(TriangleSoup& soup);
/// Copies of a facet whose corners are others at the same places, turned the same way.
/// @param place per vertex: the vertex that stands for its place (points_at_one_place()); @pre no repeated corners
std::int32_t drop_doubled(TriangleSoup& soup, std::span<const std::int32_t> place);

}  // namespace anisoquad
