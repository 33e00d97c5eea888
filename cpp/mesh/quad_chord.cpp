#include "mesh/quad_chord.h"

#include "mesh/euler_operators.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

bool is_quad(const SurfaceMesh& mesh, HalfEdge h) { return !mesh.is_boundary(h) && mesh.is_quad(mesh.face(h)); }

Vertex halve(SurfaceMesh& mesh, Edge e) {
    const HalfEdge h = M::halfedge(e);
    const bool in_row = mesh.info(mesh.from(h)).in_row && mesh.info(mesh.to(h)).in_row;
    const Vertex v = insert_vertex(mesh, e, 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    mesh.info(v).in_row = in_row;
    return v;
}

/// The half-edge that leaves the new node in the given face.
HalfEdge leaving(const SurfaceMesh& mesh, Vertex v, Face f) {
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (mesh.face(h) == f) return h;
    }
    return {};
}

void join_with_apex(SurfaceMesh& mesh, Vertex v, Face triangle) {
    if (!triangle.is_valid()) return;
    const HalfEdge out = leaving(mesh, v, triangle);
    insert_edge(mesh, out, mesh.next(mesh.next(out)));
}

}  // namespace

HalfEdge chord_end(const SurfaceMesh& mesh, HalfEdge h, int& quads) {
    quads = 0;
    HalfEdge k = M::twin(h);
    for (; is_quad(mesh, k); k = M::twin(mesh.next(mesh.next(k)))) ++quads;
    return k;
}

void split_chord(SurfaceMesh& mesh, HalfEdge h, std::vector<Vertex>& nodes) {
    Face beyond = mesh.face(M::twin(h));
    const Face before = mesh.face(h);
    bool quad = is_quad(mesh, M::twin(h));
    Vertex v = halve(mesh, M::edge(h));
    nodes.push_back(v);
    join_with_apex(mesh, v, before);
    while (quad) {
        // v, a, b, c, d: the opposite side is b – c.
        const HalfEdge opposite = mesh.next(mesh.next(leaving(mesh, v, beyond)));
        const Face after = mesh.face(M::twin(opposite));
        quad = is_quad(mesh, M::twin(opposite));
        const Vertex w = halve(mesh, M::edge(opposite));
        nodes.push_back(w);
        insert_edge(mesh, leaving(mesh, v, beyond), leaving(mesh, w, beyond));
        v = w;
        beyond = after;
    }
    join_with_apex(mesh, v, beyond);
}

}  // namespace anisoquad
