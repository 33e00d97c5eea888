#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// An edge of an anisotropic row that will be built.
struct RowEdge {
    std::array<Point, 2> ends;
    std::int32_t pass = 0;  ///< 1-based pass that builds the row
};

/// The rows that quad_mesh() would build along the sources, without the fill, the clean-up and the smoothing that follow:
/// for a picture before meshing.
/// @throws Error for what quad_mesh() rejects
std::vector<RowEdge> preview_rows(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                                  std::span<const Source> sources, const Options& options);

}  // namespace anisoquad
