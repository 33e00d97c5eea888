#include "smoothing/isoparametric.h"

namespace anisoquad {

bool isoparametric_target(const SurfaceMesh& mesh, Vertex v, Point& target) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int quads = 0;
    const Point& centre = mesh.position(v);
    for (HalfEdge h : mesh.outgoing(v)) {
        if (mesh.is_boundary(h) || !mesh.is_quad(mesh.face(h))) continue;
        const Point& next = mesh.position(mesh.to(h));
        const Point& opposite = mesh.position(mesh.to(mesh.next(h)));
        const Point& previous = mesh.position(mesh.from(mesh.prev(h)));
        sum += (next - opposite) + (previous - centre);
        ++quads;
    }
    if (quads == 0) return false;
    target = centre + sum / quads;
    return true;
}

}  // namespace anisoquad
