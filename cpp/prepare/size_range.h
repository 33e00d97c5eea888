#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// Between which edge lengths the remeshing of a surface stays, in mesh units.
struct SizeRange {
    double largest = 0.0;
    double smallest = 0.0;
};

/// What Options asks for; where it asks for nothing, as many quads as half of the triangles would make, all of one size.
/// @param points, triangles the input in the mesh's frame, with the given diagonal of its bounding box
/// @param unit the user's lengths over the mesh's
SizeRange size_range(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles, double diagonal,
                     double unit, const Options& options);

}  // namespace anisoquad
