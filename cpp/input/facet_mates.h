#pragma once

#include <cstdint>
#include <vector>

#include "input/triangle_soup.h"

/// Steps of the repair on the connectivity of facets. `mate` holds for every corner (3·facet + corner) the corner whose edge
/// is the same edge of the surface in another facet, -1 at a boundary.
namespace anisoquad {

/// Pairs the facets at every edge. Of three or more that meet at one edge, those are paired that enclose the inside of a solid
/// where they are oriented so, else the flattest pairs of the same orientation; the others get a boundary there.
/// @param cut receives the number of edges with more than two facets
/// @pre no repeated corners, no duplicates
std::vector<std::int32_t> pair_facets(const TriangleSoup& soup, std::int32_t& cut);

/// Turns facets so that all of a component have the same orientation, closed components with their normals outwards, others as
/// most of their facets were. A one-sided surface is cut along edges where its orientation clashes.
/// @param flipped receives the number of facets that were turned, @param cut that of edges cut
void unify_orientation(TriangleSoup& soup, std::vector<std::int32_t>& mate, std::int32_t& flipped, std::int32_t& cut);

/// Gives every fan of facets its own vertex, and halves edges until no two edges of the surface join the same two vertices.
/// @returns the number of new vertices
std::int32_t split_vertices(TriangleSoup& soup, std::vector<std::int32_t>& mate);

}  // namespace anisoquad
