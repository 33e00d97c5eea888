#pragma once

#include <Eigen/Geometry>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Shape of a triangle: its area over that of the equilateral triangle with the same sum of squared edges. 1 equilateral … 0
/// degenerate; about 2/a for an aspect ratio of a.
inline double triangle_shape(const Point& a, const Point& b, const Point& c) {
    const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return edges > 0.0 ? 3.4641016151377544 * (b - a).cross(c - a).norm() / edges : 0.0;
}

}  // namespace anisoquad
