#pragma once

#include <cstdint>

#include "input/triangle_soup.h"

namespace anisoquad {

/// Mends facets without area so that no hole or T-junction is left: the short edge of a needle is collapsed; a cap, whose
/// one corner lies on its longest edge, goes and its neighbours across that edge are cut in two at the corner. A facet that
/// hangs on its longest edge only is removed. Copies and repeated corners that arise are dropped too.
/// @pre no repeated corners
/// @returns the number of facets that were degenerate
std::int32_t mend_degenerate_facets(TriangleSoup& soup);

}  // namespace anisoquad
