#include "cleanup/patterns.h"
#include "smoothing/move_node.h"

namespace anisoquad {

void propose_doublet(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out) {
    if (!is_movable(mesh, v) || mesh.valence(v) != 2) return;
    const HalfEdge h = mesh.halfedge(v);
    const HalfEdge g = mesh.rotated_cw(h);
    Proposal& p = out.emplace_back();
    p.faces = {mesh.face(h), mesh.face(g)};
    p.replacement.quads.push_back({mesh.to(h), mesh.to(mesh.next(h)), mesh.to(g), mesh.to(mesh.next(g))});
}

}  // namespace anisoquad
