#include "smoothing/laplacian.h"

namespace anisoquad {

bool laplacian_target(const SurfaceMesh& mesh, Vertex v, Point& target) {
    // Summed as differences from the node: a model far from the origin loses no digits.
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (HalfEdge h : mesh.outgoing(v)) {
        const Eigen::Vector3d edge = mesh.position(mesh.to(h)) - mesh.position(v);
        const double length = edge.norm();
        sum += length * edge;
        weights += length;
    }
    if (!(weights > 0.0)) return false;
    target = mesh.position(v) + sum / weights;
    return true;
}

}  // namespace anisoquad
