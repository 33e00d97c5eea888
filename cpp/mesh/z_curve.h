#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Indices of the points along a Z-order curve (Morton 1966) through their bounding box: what is near on it is near in space.
/// It depends on the places alone where no two points share a cell of 1/2²¹ of the largest extent; those come in the order given.
/// Costs n log n. @pre coordinates are finite
std::vector<std::int32_t> order_along_z_curve(std::span<const Point> points);
/// The same for points that are computed, each twice, instead of stored.
/// @param point (index) → point
std::vector<std::int32_t> order_along_z_curve(std::int32_t count, const std::function<Point(std::int32_t)>& point);

}  // namespace anisoquad
