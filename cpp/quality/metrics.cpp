#include "quality/metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Edges, lengths and corner normals of a quad: what all measures share.
struct Quad {
    std::array<Vector3d, 4> edge;  ///< edge k leaves node k
    std::array<double, 4> length;

    Quad(const Point& a, const Point& b, const Point& c, const Point& d) : edge{b - a, c - b, d - c, a - d} {
        for (std::size_t k = 0; k < 4; ++k) length[k] = edge[k].norm();
    }

    bool has_zero_edge() const { return *std::min_element(length.begin(), length.end()) < std::numeric_limits<double>::min(); }
    const Vector3d& before(std::size_t k) const { return edge[(k + 3) % 4]; }
    Vector3d corner_normal(std::size_t k) const { return before(k).cross(edge[k]); }
    Vector3d first_axis() const { return edge[0] - edge[2]; }
    Vector3d second_axis() const { return edge[1] - edge[3]; }
    Vector3d center_normal() const { return first_axis().cross(second_axis()); }
    double corner_angle(std::size_t k) const { return std::atan2(corner_normal(k).norm(), -before(k).dot(edge[k])) * kDegrees; }
};

/// Length 1 whatever the size of the vector; zero stays zero.
Vector3d unit(const Vector3d& v) {
    const double largest = v.cwiseAbs().maxCoeff();
    return largest > 0.0 ? Vector3d((v / largest).normalized()) : v;
}

double scaled_jacobian(const Quad& q, const Vector3d& unit_normal) {
    if (q.has_zero_edge()) return 0.0;
    double worst = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < 4; ++k) {
        worst = std::min(worst, unit_normal.dot(q.corner_normal(k)) / (q.length[(k + 3) % 4] * q.length[k]));
    }
    return std::clamp(worst, -1.0, 1.0);
}

std::array<Point, 4> nodes(const SurfaceMesh& mesh, Face f) {
    assert(mesh.is_quad(f));
    const HalfEdge h0 = mesh.halfedge(f);
    const HalfEdge h1 = mesh.next(h0);
    const HalfEdge h2 = mesh.next(h1);
    return {mesh.position(mesh.from(h0)), mesh.position(mesh.from(h1)), mesh.position(mesh.from(h2)), mesh.position(mesh.to(h2))};
}

}  // namespace

double scaled_jacobian(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    return scaled_jacobian(q, unit(q.center_normal()));
}

double scaled_jacobian(const Point& a, const Point& b, const Point& c, const Point& d, const Vector3d& normal) {
    return scaled_jacobian(Quad(a, b, c, d), unit(normal));
}

double aspect_ratio(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    if (q.has_zero_edge()) return std::numeric_limits<double>::infinity();
    const auto [shortest, longest] = std::minmax_element(q.length.begin(), q.length.end());
    return *longest / *shortest;
}

double min_angle(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    if (q.has_zero_edge()) return 0.0;
    return std::min({q.corner_angle(0), q.corner_angle(1), q.corner_angle(2), q.corner_angle(3)});
}

double max_angle(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    if (q.has_zero_edge()) return 360.0;
    const double largest = std::max({q.corner_angle(0), q.corner_angle(1), q.corner_angle(2), q.corner_angle(3)});
    const Vector3d up = q.center_normal();
    for (std::size_t k = 0; k < 4; ++k) {
        if (up.dot(q.corner_normal(k)) < 0.0) return 360.0 - largest;
    }
    return largest;
}

double skew(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    return std::abs(unit(q.first_axis()).dot(unit(q.second_axis())));
}

double warpage(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Quad q(a, b, c, d);
    double worst = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector3d n = unit(q.corner_normal(k));
        const Vector3d m = unit(q.corner_normal(k + 2));
        worst = std::max(worst, std::atan2(n.cross(m).norm(), n.dot(m)) * kDegrees);
    }
    return worst;
}

double area(const Point& a, const Point& b, const Point& c, const Point& d) { return 0.5 * (c - a).cross(d - b).norm(); }

#define ANISOQUAD_FOR_FACE(measure)                   \
    double measure(const SurfaceMesh& mesh, Face f) { \
        const auto [a, b, c, d] = nodes(mesh, f);     \
        return measure(a, b, c, d);                   \
    }
ANISOQUAD_FOR_FACE(scaled_jacobian)
ANISOQUAD_FOR_FACE(aspect_ratio)
ANISOQUAD_FOR_FACE(min_angle)
ANISOQUAD_FOR_FACE(max_angle)
ANISOQUAD_FOR_FACE(skew)
ANISOQUAD_FOR_FACE(warpage)
ANISOQUAD_FOR_FACE(area)
#undef ANISOQUAD_FOR_FACE

double scaled_jacobian(const SurfaceMesh& mesh, Face f, const Vector3d& normal) {
    const auto [a, b, c, d] = nodes(mesh, f);
    return scaled_jacobian(a, b, c, d, normal);
}

double scaled_jacobian_of_pair(const SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge g = SurfaceMesh::twin(h);
    return scaled_jacobian(mesh.position(mesh.from(h)), mesh.position(mesh.to(mesh.next(g))), mesh.position(mesh.to(h)),
                           mesh.position(mesh.to(mesh.next(h))));
}

}  // namespace anisoquad
