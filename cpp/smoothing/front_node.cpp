#include "smoothing/front_node.h"

#include <algorithm>

#include "smoothing/isoparametric.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

/// The edge between the node's two quads, leaving the node, if it has exactly two and they are neighbours.
HalfEdge edge_between_two_quads(const SurfaceMesh& mesh, Vertex v) {
    int quads = 0;
    HalfEdge between;
    for (HalfEdge h : mesh.outgoing(v)) {
        if (mesh.is_boundary(h) || !mesh.is_quad(mesh.face(h))) continue;
        ++quads;
        const Face right = mesh.face(SurfaceMesh::twin(h));
        if (right.is_valid() && mesh.is_quad(right)) between = h;
    }
    return quads == 2 ? between : HalfEdge();
}

/// Mean length of the edges of the two quads beside h but h itself.
double desired_length(const SurfaceMesh& mesh, HalfEdge h) {
    double sum = 0.0;
    for (const HalfEdge side : {h, SurfaceMesh::twin(h)}) {
        HalfEdge g = mesh.next(side);
        for (int k = 0; k < 3; ++k, g = mesh.next(g)) sum += mesh.length(g);
    }
    return sum / 6.0;
}

/// Place of the node on the bisector at the lower end: the mean of the angle that the lower ends' opposite front nodes span
/// and of the direction of the edge. Zero direction = none.
Vector3d bisector(const Vector3d& left, const Vector3d& right, const Vector3d& edge) {
    const Vector3d e = edge.normalized();
    Vector3d half = left.normalized() + right.normalized();
    // A straight or reflex angle: the bisector is found from the side on which the edge lies.
    if (half.norm() < 1e-6) return e;
    half.normalize();
    if (half.dot(e) < 0.0) half = -half;
    return (half + e).normalized();
}

}  // namespace

bool front_node_target(const SurfaceMesh& mesh, Vertex v, Point& target) {
    if (!isoparametric_target(mesh, v, target)) return false;
    const HalfEdge h = edge_between_two_quads(mesh, v);
    if (!h.is_valid()) return true;

    const Point& node = mesh.position(v);
    const Point& lower = mesh.position(mesh.to(h));
    // Blacker (1991), row smoothing. A: isoparametric, B: desired length, C: angle; B and C are averaged.
    const Vector3d isoparametric = target - lower;
    const double length = isoparametric.norm();
    if (!(length > 0.0)) return true;
    // The wanted size of the place, as far as it fits the quads beside the edge.
    const double mean = desired_length(mesh, h);
    const double size = mesh.info(v).size;
    const double wanted = size > 0.0 ? std::clamp(size, 0.3 * mean, 2.0 * mean) : mean;
    const Vector3d by_length = wanted / length * isoparametric;

    // The front neighbours of the node, seen from the lower end.
    const Vector3d left = mesh.position(mesh.from(mesh.prev(h))) - lower;
    const Vector3d right = mesh.position(mesh.to(mesh.next(SurfaceMesh::twin(h)))) - lower;
    const Vector3d direction = bisector(left, right, node - lower);
    // Where the bisector meets the line between the front neighbours: beyond it the length is held back.
    const Vector3d chord = right - left;
    const Vector3d off = chord - chord.dot(direction) * direction;
    double reach = wanted;
    if (off.squaredNorm() > 1e-12 * chord.squaredNorm()) {
        const double t = std::clamp(-left.dot(off) / off.squaredNorm(), 0.0, 1.0);
        const double meets = (left + t * chord).dot(direction);
        if (meets > 0.0 && wanted > meets) reach = 0.5 * (wanted + meets);
    }
    target = lower + 0.5 * (by_length + reach * direction);
    return true;
}

}  // namespace anisoquad
