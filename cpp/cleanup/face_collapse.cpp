#include "cleanup/patterns.h"
#include "smoothing/move_node.h"

namespace anisoquad {

void propose_collapse_of(const SurfaceMesh& mesh, HalfEdge h, std::vector<Proposal>& out) {
    const Vertex v = mesh.from(h);
    if (!is_movable(mesh, v) || mesh.valence(v) < 3) return;
    const Vertex kept = mesh.to(mesh.next(h));
    Proposal& p = out.emplace_back();
    p.faces.push_back(mesh.face(h));
    for (HalfEdge k = mesh.rotated_ccw(h); k != h; k = mesh.rotated_ccw(k)) {
        p.faces.push_back(mesh.face(k));
        p.replacement.quads.push_back({kept, mesh.to(k), mesh.to(mesh.next(k)), mesh.from(mesh.prev(k))});
    }
}

void propose_face_collapse(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out) {
    if (!is_movable(mesh, v)) return;
    for (const HalfEdge h : mesh.outgoing(v)) propose_collapse_of(mesh, h, out);
}

}  // namespace anisoquad
