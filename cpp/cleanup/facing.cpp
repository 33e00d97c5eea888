#include "cleanup/facing.h"

namespace anisoquad {

Eigen::Vector3d facing(const SurfaceMesh& mesh, Face quad) {
    const auto is_line = [&](Edge e) { return mesh.is_constrained(e); };
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const HalfEdge h : mesh.halfedges(quad)) {
        HalfEdge first = h;
        while (!is_line(SurfaceMesh::edge(first))) {
            first = mesh.rotated_cw(first);
            if (first == h) break;
        }
        sum += facing(mesh, first, is_line);
    }
    return sum;
}

}  // namespace anisoquad
