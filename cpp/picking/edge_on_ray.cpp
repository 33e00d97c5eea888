#include "picking/edge_on_ray.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace anisoquad {
namespace {

using Eigen::Vector3d;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Vector3d ab = b - a;
    const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (a + t * ab - p).norm();
}

}  // namespace

EdgeHit edge_on_ray(const PickSurface& surface, const Point& origin, const Vector3d& direction) {
    EdgeHit hit;
    double nearest = std::numeric_limits<double>::infinity();
    const auto corner = [&](const std::array<std::int32_t, 3>& t, std::size_t k) -> const Point& {
        return surface.points[static_cast<std::size_t>(t[k % 3])];
    };
    for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
        // Möller and Trumbore, without the cull of back faces.
        const auto& t = surface.triangles[f];
        const Vector3d ab = corner(t, 1) - corner(t, 0);
        const Vector3d ac = corner(t, 2) - corner(t, 0);
        const Vector3d p = direction.cross(ac);
        const double determinant = ab.dot(p);
        if (determinant == 0.0) continue;
        const Vector3d s = (origin - corner(t, 0)) / determinant;
        const double u = s.dot(p);
        if (u < 0.0 || u > 1.0) continue;
        const Vector3d q = s.cross(ab);
        const double v = direction.dot(q);
        const double way = ac.dot(q);
        if (v < 0.0 || u + v > 1.0 || way < 0.0 || way >= nearest) continue;
        nearest = way;
        hit.facet = static_cast<std::int32_t>(f);
    }
    if (hit.facet < 0) return hit;
    const auto& t = surface.triangles[static_cast<std::size_t>(hit.facet)];
    hit.point = origin + nearest * direction;
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const double distance = distance_to_segment(hit.point, corner(t, k), corner(t, k + 1));
        if (distance >= closest) continue;
        closest = distance;
        hit.from = t[k];
        hit.to = t[(k + 1) % 3];
        hit.nearest = (hit.point - corner(t, k)).norm() <= (hit.point - corner(t, k + 1)).norm() ? hit.from : hit.to;
    }
    return hit;
}

}  // namespace anisoquad
