#include "smoothing/angle.h"

#include <Eigen/Geometry>
#include <cmath>

#include "smoothing/move_node.h"

namespace anisoquad {

bool angle_target(const SurfaceMesh& mesh, Vertex v, Point& target) {
    if (mesh.is_boundary(v)) return false;
    const Eigen::Vector3d normal = node_normal(mesh, v);
    if (normal.isZero(0.0)) return false;
    const Point& centre = mesh.position(v);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (HalfEdge h : mesh.outgoing(v)) {
        const Point& at = mesh.position(mesh.to(h));
        const Eigen::Vector3d edge = centre - at;
        const double length = edge.norm();
        // The edges beside h at its far end: next of h in the face on the left, previous of its twin in that on the right.
        const Eigen::Vector3d left = (mesh.position(mesh.to(mesh.next(h))) - at).normalized();
        const Eigen::Vector3d right = (mesh.position(mesh.from(mesh.prev(SurfaceMesh::twin(h)))) - at).normalized();
        // Angles in the tangent plane from right to edge and from edge to left; their bisector is where the edge should be.
        const double to_right = std::atan2(normal.dot(edge.cross(right)), edge.dot(right));
        const double to_left = std::atan2(normal.dot(edge.cross(left)), edge.dot(left));
        const double opening = to_right - to_left;
        if (!(length > 0.0) || !(opening > 0.0)) continue;
        const double turn = 0.5 * (to_right + to_left);
        const Eigen::Vector3d turned =
            std::cos(turn) * edge + std::sin(turn) * normal.cross(edge) - (std::cos(turn) - 1.0) * normal.dot(edge) * normal;
        const double weight = 1.0 / (opening * opening);
        sum += weight * (turned - edge);
        weights += weight;
    }
    if (!(weights > 0.0)) return false;
    target = centre + sum / weights;
    return true;
}

}  // namespace anisoquad
