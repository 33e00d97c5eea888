#include "picking/zigzag.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 0.2;  ///< radians: turns of a zigzag
constexpr int kApart = 3;      ///< nodes: turns that follow each other farther apart are none

double angle_between(const SurfaceMesh& mesh, HalfEdge first, HalfEdge last) {
    double sum = 0.0;
    for (HalfEdge h = first; h != last; h = mesh.rotated_ccw(h)) {
        if (mesh.is_boundary(h)) return std::numbers::pi;  // the end of the surface is not a turn
        const Vector3d a = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
        const Vector3d b = mesh.position(mesh.from(mesh.prev(h))) - mesh.position(mesh.from(h));
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
}

/// Turn of the path at a node, positive to the left.
double turn(const SurfaceMesh& mesh, Vertex before, Vertex at, Vertex after) {
    const HalfEdge in = mesh.find_halfedge(at, before);
    const HalfEdge out = mesh.find_halfedge(at, after);
    return 0.5 * (angle_between(mesh, in, out) - angle_between(mesh, out, in));
}

}  // namespace

bool is_zigzag(const SurfaceMesh& mesh, std::span<const Vertex> path) {
    double last = 0.0;
    int since = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i, ++since) {
        const double here = turn(mesh, path[i - 1], path[i], path[i + 1]);
        if (std::abs(here) < kTurn) continue;
        if (here * last < 0.0 && since <= kApart) return true;
        last = here;
        since = 0;
    }
    return false;
}

}  // namespace anisoquad
