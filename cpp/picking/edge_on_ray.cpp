#include "picking/edge_on_ray.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHidden = 10.0;  ///< reaches: an edge that is so much behind the facet in front of it can still be seen

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Vector3d ab = b - a;
    const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (a + t * ab - p).norm();
}

/// A ray with a direction of length 1.
struct Ray {
    Point origin;
    Vector3d direction;

    Point at(double way) const { return origin + way * direction; }
};

struct Passing {
    double distance = kInfinity;  ///< between the ray and the segment
    double way = 0.0;             ///< along the ray
};

Passing passing(const Ray& ray, const Point& a, const Point& b) {
    const Vector3d ab = b - a;
    const Vector3d ao = ray.origin - a;
    const double slope = ab.dot(ray.direction);
    const double determinant = ab.squaredNorm() - slope * slope;
    double t = determinant > 0.0 ? (ao.dot(ab) - slope * ao.dot(ray.direction)) / determinant : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    const Point p = a + t * ab;
    const double way = std::max((p - ray.origin).dot(ray.direction), 0.0);
    return {(p - ray.at(way)).norm(), way};
}

/// Facet that the ray meets first @cite moeller1997, and the way to it.
std::pair<std::int32_t, double> first_facet(const PickSurface& surface, const Ray& ray) {
    std::pair<std::int32_t, double> first{-1, kInfinity};
    for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
        const auto corner = [&](std::size_t k) -> const Point& {
            return surface.points[static_cast<std::size_t>(surface.triangles[f][k])];
        };
        const Vector3d ab = corner(1) - corner(0);
        const Vector3d ac = corner(2) - corner(0);
        const Vector3d p = ray.direction.cross(ac);
        const double determinant = ab.dot(p);
        if (determinant == 0.0) continue;
        const Vector3d s = (ray.origin - corner(0)) / determinant;
        const double u = s.dot(p);
        if (u < 0.0 || u > 1.0) continue;
        const Vector3d q = s.cross(ab);
        const double v = ray.direction.dot(q);
        const double way = ac.dot(q);
        if (v >= 0.0 && u + v <= 1.0 && way >= 0.0 && way < first.second) first = {static_cast<std::int32_t>(f), way};
    }
    return first;
}

}  // namespace

EdgeHit edge_on_ray(const PickSurface& surface, const Point& origin, const Vector3d& direction, double reach) {
    const Ray ray{origin, direction.normalized()};
    const std::pair<std::int32_t, double> first = first_facet(surface, ray);
    const std::int32_t facet = first.first;
    const double facet_way = first.second;  // clang before 16 captures no structured bindings
    EdgeHit hit;
    hit.facet = facet;
    double nearest = reach;
    double edge_way = 0.0;
    const auto point = [&](std::int32_t v) -> const Point& { return surface.points[static_cast<std::size_t>(v)]; };
    const auto try_edge = [&](std::int32_t from, std::int32_t to) {
        const Passing pass = passing(ray, point(from), point(to));
        if (pass.distance >= nearest || pass.way > facet_way + kHidden * reach) return;
        nearest = pass.distance;
        edge_way = pass.way;
        hit.from = from;
        hit.to = to;
    };
    for (const FeatureLine& line : surface.lines) {
        for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i) try_edge(line.nodes[i].index(), line.nodes[i + 1].index());
    }
    if (facet >= 0) {
        hit.point = ray.at(facet_way);
        if (hit.from >= 0) return hit;
        double closest = kInfinity;
        const auto& t = surface.triangles[static_cast<std::size_t>(facet)];
        for (std::size_t k = 0; k < 3; ++k) {
            const double distance = distance_to_segment(hit.point, point(t[k]), point(t[(k + 1) % 3]));
            if (distance >= closest) continue;
            closest = distance;
            hit.from = t[k];
            hit.to = t[(k + 1) % 3];
        }
        return hit;
    }
    if (hit.from < 0 && reach > 0.0) {
        for (std::int32_t e = 0; e < surface.mesh.edge_slots(); ++e) {
            const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
            try_edge(surface.mesh.from(h).index(), surface.mesh.to(h).index());
        }
    }
    hit.point = ray.at(edge_way);
    return hit;
}

}  // namespace anisoquad
