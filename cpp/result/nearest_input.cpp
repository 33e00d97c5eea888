#include "result/nearest_input.h"

#include "mesh/face_middle.h"

namespace anisoquad {

void find_nearest_input(const SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines,
                        QuadMeshResult& result) {
    std::int32_t hint = -1;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const Face f(i);
        if (mesh.is_deleted(f)) continue;
        hint = reference.closest(face_middle(mesh, f), mesh.info(f).patch, hint).facet;
        result.quad_facet.push_back(hint);
    }
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (mesh.is_deleted(Edge(e)) || mesh.info(Edge(e)).line < 0) continue;
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        const Point middle = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
        result.line_edge_input.push_back(lines.closest_edge(mesh.info(Edge(e)).line, middle).edge);
    }
}

}  // namespace anisoquad
