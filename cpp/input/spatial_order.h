#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// An order of vertices and triangles in which neighbours in space are near each other in memory.
struct SpatialOrder {
    std::vector<std::int32_t> vertex;    ///< input vertex at each place of the order
    std::vector<std::int32_t> rank;      ///< place of each input vertex
    std::vector<std::int32_t> triangle;  ///< input triangle at each place of the order
};

/// Vertices along a Z-order curve (Morton 1966) through the bounding box, triangles by their vertices' places. It depends on the
/// coordinates alone, not on the order of the input, where no two vertices share a cell of 1/2²¹ of the largest extent.
/// Costs n log n of the vertices. @pre coordinates are finite, indices in range
SpatialOrder spatial_order(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace anisoquad
