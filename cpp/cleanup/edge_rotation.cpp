#include "cleanup/patterns.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

void propose(const SurfaceMesh& mesh, HalfEdge h, std::vector<Proposal>& out) {
    if (is_fixed(mesh, M::edge(h))) return;
    const HalfEdge g = M::twin(h);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.to(h);
    const Vertex left_b = mesh.to(mesh.next(h));
    const Vertex left_a = mesh.from(mesh.prev(h));
    const Vertex right_a = mesh.to(mesh.next(g));
    const Vertex right_b = mesh.from(mesh.prev(g));
    // The hexagon is a, right_a, right_b, b, left_b, left_a.
    for (const bool clockwise : {false, true}) {
        Proposal& p = out.emplace_back();
        p.faces = {mesh.face(h), mesh.face(g)};
        if (clockwise) {
            p.replacement.quads = {{left_a, a, right_a, right_b}, {left_a, right_b, b, left_b}};
        } else {
            p.replacement.quads = {{right_a, right_b, b, left_b}, {right_a, left_b, left_a, a}};
        }
    }
}

}  // namespace

void propose_edge_rotation(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out) {
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!is_fixed(mesh, M::edge(h))) propose(mesh, h, out);
        if (mesh.is_boundary(h) || mesh.info(mesh.face(h)).row > 0) continue;
        const HalfEdge opposite = mesh.next(h);
        for (const HalfEdge side : {opposite, mesh.next(opposite)}) {
            if (!is_fixed(mesh, M::edge(side))) propose(mesh, side, out);
        }
    }
}

}  // namespace anisoquad
