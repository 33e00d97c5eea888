#include "smoothing/length.h"

namespace anisoquad {

bool length_target(const SurfaceMesh& mesh, Vertex v, Point& target) {
    Eigen::Vector3d edges = Eigen::Vector3d::Zero();
    Eigen::Vector3d directions = Eigen::Vector3d::Zero();
    double total = 0.0;
    int count = 0;
    for (HalfEdge h : mesh.outgoing(v)) {
        const Eigen::Vector3d edge = mesh.position(mesh.to(h)) - mesh.position(v);
        const double length = edge.norm();
        if (!(length > 0.0)) return false;
        edges += edge;
        directions += edge / length;
        total += length;
        ++count;
    }
    if (count == 0) return false;
    // The sum of (l − mean l)·direction, over the number of springs.
    target = mesh.position(v) + (edges - total / count * directions) / count;
    return true;
}

}  // namespace anisoquad
