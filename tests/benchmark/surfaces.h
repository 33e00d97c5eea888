#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "options.h"

namespace anisoquad::benchmarks {

struct Surface {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> leading_edge;
};

/// Unit square of about so many triangles, regular but for a fifth of the spacing by which its nodes are displaced.
Surface plane(int triangles);
/// Unit sphere, made from an icosahedron's faces divided evenly.
Surface sphere(int triangles);
/// Wing of tests/data, its triangles cut into four until there are at least so many.
Surface wing(const std::string& name, int triangles);

}  // namespace anisoquad::benchmarks
