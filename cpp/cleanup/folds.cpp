#include "cleanup/folds.h"

#include "cleanup/sectors.h"
#include "mesh/area_vector.h"

namespace anisoquad {

int count_folds(const SurfaceMesh& mesh, std::span<const Face> faces) {
    int folds = 0;
    for (const Face f : faces) {
        const Eigen::Vector3d area = doubled_area_vector_of_quad(mesh, f);
        for (const HalfEdge h : mesh.halfedges(f)) {
            if (h.index() % 2 != 0) continue;  // inner edges once
            const Face beside = mesh.face(SurfaceMesh::twin(h));
            if (is_fixed(mesh, SurfaceMesh::edge(h)) || !mesh.is_quad(beside)) continue;
            folds += area.dot(doubled_area_vector_of_quad(mesh, beside)) < 0.0 ? 1 : 0;
        }
    }
    return folds;
}

}  // namespace anisoquad
