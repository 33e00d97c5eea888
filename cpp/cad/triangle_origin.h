#pragma once

#include <cstdint>
#include <vector>

#include "cad/edge_paths.h"

namespace anisoquad::cad {

/// What of the shape triangles were made from, as the one who made them knows it.
struct TriangleOrigin {
    std::vector<std::int32_t> facet_face;  ///< per triangle: its CAD face, -1 = not known; empty: of none
    std::vector<EdgePath> paths;           ///< per CAD edge: the vertices on it, none where it is not known; empty: of none
};

}  // namespace anisoquad::cad
