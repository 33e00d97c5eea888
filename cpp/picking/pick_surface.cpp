#include "picking/pick_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "input/check.h"
#include "mesh/arrays.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

Vector3d doubled_area(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    const Point& a = mesh.position(mesh.from(h));
    return (mesh.position(mesh.to(h)) - a).cross(mesh.position(mesh.to(mesh.next(h))) - a);
}

double edge_curvature(const SurfaceMesh& mesh, Edge e) {
    if (mesh.is_boundary(e)) return 0.0;
    const HalfEdge h = M::halfedge(e);
    const Vector3d left = doubled_area(mesh, mesh.face(h));
    const Vector3d right = doubled_area(mesh, mesh.face(M::twin(h)));
    const Vector3d along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
    const double turn = std::atan2(left.cross(right).dot(along), left.dot(right));
    return turn * 2.0 * mesh.length(h) / (left.norm() + right.norm());
}

}  // namespace

PickSurface make_pick_surface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                              double feature_angle, std::span<const std::array<std::int32_t, 2>> feature_edges) {
    Options options;
    options.feature_angle = feature_angle;
    options.feature_edges.assign(feature_edges.begin(), feature_edges.end());
    check_options(options);
    check_input(points, triangles);
    PickSurface surface;
    surface.points.assign(points.begin(), points.end());
    surface.triangles.assign(triangles.begin(), triangles.end());
    surface.mesh = from_arrays(points, triangles);
    surface.lines = find_features(surface.mesh, {}, options);
    Point low = points[0];
    Point high = points[0];
    for (const Point& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    surface.diagonal = (high - low).norm();
    double sum = 0.0;
    double length = 0.0;
    for (std::int32_t e = 0; e < surface.mesh.edge_slots(); ++e) {
        surface.curvature.push_back(edge_curvature(surface.mesh, Edge(e)));
        sum += std::abs(surface.curvature.back()) * surface.mesh.length(Edge(e));
        length += surface.mesh.length(Edge(e));
    }
    surface.mean_curvature = std::max(sum / length, 0.1 / surface.diagonal);
    return surface;
}

}  // namespace anisoquad
