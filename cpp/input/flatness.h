#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Twice the area of a facet over the square of its longest edge; not a number when all corners are at one place.
inline double flatness(const Point& a, const Point& b, const Point& c) {
    const Point u = b - a;
    const Point v = c - a;
    return u.cross(v).norm() / std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
}

/// Flatness up to which a facet is degenerate: it has no usable normal.
inline constexpr double kNoArea = 1e-9;

}  // namespace anisoquad
