#include "mesh/flip_check.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace anisoquad {

bool flip_keeps_surface(const SurfaceMesh& mesh, Edge e, double least) {
    using Eigen::Vector3d;
    constexpr double kLessSharp = 0.02;  // a flip that folds a little more would let creases wander
    const HalfEdge h = SurfaceMesh::halfedge(e);
    const Point& p = mesh.position(mesh.from(h));
    const Point& q = mesh.position(mesh.to(h));
    const Point& l = mesh.position(mesh.to(mesh.next(h)));
    const Point& r = mesh.position(mesh.to(mesh.next(SurfaceMesh::twin(h))));
    const Vector3d left = (q - p).cross(l - p);
    const Vector3d right = (r - p).cross(q - p);
    const Vector3d first = (r - p).cross(l - p);
    const Vector3d second = (l - q).cross(r - q);
    const Vector3d n = left + right;
    if (first.dot(n) <= 0.0 || second.dot(n) <= 0.0) return false;
    const double before = left.normalized().dot(right.normalized());
    return first.normalized().dot(second.normalized()) >= std::min(least, before - kLessSharp);
}

}  // namespace anisoquad
