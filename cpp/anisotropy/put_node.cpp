#include "anisotropy/put_node.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/euler_operators.h"
#include "qmorph/front.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kLeastTriangle = 0.01;  ///< quality of the triangles round the node
constexpr double kBeside = 0.1;          ///< distance from an edge that is split, over its length
constexpr double kBetweenEnds = 0.05;    ///< of such an edge, over its length

/// A triangle node that no front, line or row holds.
bool is_free(const SurfaceMesh& mesh, Vertex v) {
    if (!is_movable(mesh, v)) return false;
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_triangle(mesh.face(h))) return false;
    }
    return true;
}

/// Moves the node if the triangles round it stay usable.
bool move_there(SurfaceMesh& mesh, Vertex v, const Point& place) {
    const Point kept = mesh.position(v);
    const Vector3d normal = node_normal(mesh, v);
    mesh.position(v) = place;
    if (worst_quality(mesh, v, normal) > kLeastTriangle) return true;
    mesh.position(v) = kept;
    return false;
}

}  // namespace

Vertex put_node(SurfaceMesh& mesh, const TraceEnd& end, double reach) {
    Vertex nearest;
    double best = reach;
    for (const HalfEdge h : mesh.halfedges(end.face)) {
        const Vertex v = mesh.from(h);
        const double distance = (mesh.position(v) - end.position).norm();
        if (distance < best && is_free(mesh, v)) {
            best = distance;
            nearest = v;
        }
    }
    if (nearest.is_valid() && move_there(mesh, nearest, end.position)) {
        mesh.info(nearest).input = -1;
        return nearest;
    }
    // Close to an edge: split it there, so that no sliver comes up.
    for (const HalfEdge h : mesh.halfedges(end.face)) {
        const Point& from = mesh.position(mesh.from(h));
        const Vector3d along = mesh.position(mesh.to(h)) - from;
        const Vector3d offset = end.position - from;
        const double t = along.dot(offset) / along.squaredNorm();
        const double distance = (offset - t * along).norm();
        if (distance > kBeside * along.norm() || t < kBetweenEnds || t > 1.0 - kBetweenEnds) continue;
        if (is_front(mesh, h) || is_front(mesh, M::twin(h)) || mesh.is_constrained(M::edge(h))) continue;
        if (!mesh.is_triangle(mesh.face(M::twin(h)))) continue;
        const Vertex v = split_edge(mesh, M::edge(h), from + t * along);
        // Beside the edge all the same, where it can be: columns that jump to edges run ever more unevenly.
        move_there(mesh, v, end.position);
        return v;
    }
    return split_face(mesh, end.face, end.position);
}

}  // namespace anisoquad
