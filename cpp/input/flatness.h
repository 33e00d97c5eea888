#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

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
/// Longest edge over the model's diagonal up to which a facet is degenerate: beside the model it is a point.
inline constexpr double kNoSize = 1e-12;

/// Bounding box of the facets' corners; empty without facets. @pre indices in range
inline Eigen::AlignedBox3d bounding_box(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    Eigen::AlignedBox3d box;
    for (const auto& t : triangles) {
        for (const std::int32_t v : t) box.extend(points[static_cast<std::size_t>(v)]);
    }
    return box;
}

/// Diagonal of the bounding box of the facets' corners. @pre indices in range
inline double diagonal(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    return triangles.empty() ? 0.0 : bounding_box(points, triangles).diagonal().norm();
}

/// True for a facet on which no later stage could work. @param margin over both bounds, so that rounding does not decide
inline bool is_degenerate(const Point& a, const Point& b, const Point& c, double diagonal, double margin = 1.0) {
    if (!(flatness(a, b, c) > margin * kNoArea)) return true;
    const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
    return !(std::sqrt(longest) > margin * kNoSize * diagonal);
}

}  // namespace anisoquad
