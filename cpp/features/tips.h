#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// The top of a cone or of a needle: a point of the surface that elements would cut off, to which no line leads.
struct Tip {
    Point place;
    std::int32_t patch = -1;
    std::int32_t input = -1;  ///< VertexInfo::input of the vertex there
};

/// Vertices off all lines where the angles of the triangles sum up to far less than a full turn, and to less than at any
/// neighbour off the lines: on a coarse sphere or a rough scan they do so everywhere, which makes no tip.
/// @param mesh triangles, fresh from find_features() and find_patches()
/// @returns in the order of the vertices' slots
std::vector<Tip> find_tips(const SurfaceMesh& mesh);

}  // namespace anisoquad
