#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace anisoquad::cad {

/// check_input() of the core, whose headers can not be included beside OpenCASCADE's: both have a `Handle`.
/// @throws Error
void check_triangles(std::span<const Eigen::Vector3d> points, std::span<const std::array<std::int32_t, 3>> triangles);

/// repair_surface() of the core: facets without area, which tessellations of flat faces have where points lie on a line, go.
/// @param lines of vertices along edges, that follow
/// @returns for each triangle the one at the same places before, -1 = none
std::vector<std::int32_t> mend_triangles(std::vector<Eigen::Vector3d>& points,
                                         std::vector<std::array<std::int32_t, 3>>& triangles,
                                         std::vector<std::vector<std::int32_t>>& lines);

}  // namespace anisoquad::cad
