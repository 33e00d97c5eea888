#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// A triangulation that has a straightened path among its edges.
struct ImprintResult {
    std::vector<Point> points;  ///< the input points under their ids, then new ones
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> path;
    std::int32_t pieces = 0;  ///< stretches that were straightened; 0: nothing was changed
};

/// Straightens the zigzags of a path into the triangles: each becomes a geodesic between vertices of the path that is nowhere
/// farther from it than a mean edge, and is then made of new edges (splits), with the nodes too near to it taken away
/// (collapses) and the triangles beside it improved (flips). Feature lines and the edges of the surface that are constrained
/// stay as they are; what can not be straightened without crossing them is left.
/// @param surface made with the edges of other lines as feature edges
/// @param path neighbours joined by mesh edges, no vertex twice but for a closed path's end
/// @throws Error{invalid_source} for what is no such path
ImprintResult imprint(const PickSurface& surface, std::span<const std::int32_t> path);

}  // namespace anisoquad
