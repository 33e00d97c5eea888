#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Indices of the points along a Z-order curve (Morton 1966) through their bounding box: what is near on it is near in space.
/// It depends on the places alone where no two points share a cell of 1/2²¹ of the largest extent; those come in the order given.
/// Costs n log n. @pre coordinates are finite
std::vector<std::int32_t> order_along_z_curve(std::span<const Point> points);

}  // namespace anisoquad
