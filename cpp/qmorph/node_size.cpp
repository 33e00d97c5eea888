#include "qmorph/node_size.h"

#include <Eigen/Geometry>
#include <cmath>

#include "parallel.h"

namespace anisoquad {

// Fronts keep the edges of the lines they start from, which are a little longer: this makes up for it.
constexpr double kDensity = 0.95;

void assign_node_sizes(SurfaceMesh& mesh) {
    for_each(mesh.vertex_slots(), [&](std::int32_t i) {
        const Vertex v(i);
        if (mesh.is_deleted(v)) return;
        const Point& p = mesh.position(v);
        double doubled_area = 0.0;
        int triangles = 0;
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (mesh.is_boundary(h) || !mesh.is_triangle(mesh.face(h))) continue;
            doubled_area += (mesh.position(mesh.to(h)) - p).cross(mesh.position(mesh.to(mesh.next(h))) - p).norm();
            ++triangles;
        }
        if (triangles > 0) mesh.info(v).size = kDensity * std::sqrt(doubled_area / triangles);
    });
}

}  // namespace anisoquad
