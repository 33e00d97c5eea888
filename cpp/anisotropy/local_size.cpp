#include "anisotropy/local_size.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace anisoquad {

LocalSize::LocalSize(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                     const ReferenceSurface& reference)
    : reference_(reference), facet_size_(triangles.size()) {
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const auto& t = triangles[f];
        const auto p = [&](std::size_t k) -> const Point& { return points[static_cast<std::size_t>(t[k])]; };
        // Edge of the equilateral triangle of the same area.
        facet_size_[f] = std::sqrt(2.0 / std::numbers::sqrt3 * (p(1) - p(0)).cross(p(2) - p(0)).norm());
    }
    // Two sweeps of facets → vertices → facets take the noise out.
    std::vector<double> sum(points.size());
    std::vector<double> count(points.size());
    for (int sweep = 0; sweep < 2; ++sweep) {
        sum.assign(points.size(), 0.0);
        count.assign(points.size(), 0.0);
        for (std::size_t f = 0; f < triangles.size(); ++f) {
            for (const std::int32_t v : triangles[f]) {
                sum[static_cast<std::size_t>(v)] += facet_size_[f];
                count[static_cast<std::size_t>(v)] += 1.0;
            }
        }
        for (std::size_t f = 0; f < triangles.size(); ++f) {
            double mean = 0.0;
            for (const std::int32_t v : triangles[f])
                mean += sum[static_cast<std::size_t>(v)] / count[static_cast<std::size_t>(v)];
            facet_size_[f] = mean / 3.0;
        }
    }
}

double LocalSize::operator()(const Point& p, std::int32_t& hint) const {
    const SurfacePoint closest = reference_.closest(p, ReferenceSurface::kAnyPatch, hint);
    hint = closest.facet;
    return facet_size_[static_cast<std::size_t>(closest.facet)];
}

}  // namespace anisoquad
