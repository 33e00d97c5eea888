#include "prepare/size_range.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace anisoquad {
namespace {

// Limits of the size that stands in for a wanted one, over the model's diagonal.
constexpr double kLeastSize = 1.0 / 200.0;
constexpr double kMostSize = 1.0 / 40.0;
constexpr double kShare = 0.87;         ///< of the side of the square of two mean triangles
constexpr double kFineness = 3.0;       ///< largest over smallest size where none is asked for
constexpr double kFinenessAsked = 8.0;  ///< where one is

}  // namespace

SizeRange size_range(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles, double diagonal,
                     double unit, const Options& options) {
    if (!options.vertex_size.empty()) {
        const auto [least, most] = std::minmax_element(options.vertex_size.begin(), options.vertex_size.end());
        return {*most / unit, *least / unit / kFinenessAsked};
    }
    if (options.size > 0.0) return {options.size / unit, options.size / unit / kFinenessAsked};
    double area = 0.0;
    for (const auto& t : triangles) {
        const auto p = [&](std::size_t k) -> const Point& { return points[static_cast<std::size_t>(t[k])]; };
        area += 0.5 * (p(1) - p(0)).cross(p(2) - p(0)).norm();
    }
    const double size = kShare * std::sqrt(2.0 * area / static_cast<double>(triangles.size()));
    const double largest = std::clamp(size, kLeastSize * diagonal, kMostSize * diagonal);
    return {largest, largest / kFineness};
}

}  // namespace anisoquad
