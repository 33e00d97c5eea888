#include "qmorph/rung.h"

#include "mesh/euler_operators.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kWide = 3.5;  ///< length over the mean of the wanted sizes

/// The half-edge that leaves v inside the face.
HalfEdge leaving(const SurfaceMesh& mesh, Vertex v, Face f) {
    for (const HalfEdge h : mesh.halfedges(f)) {
        if (mesh.from(h) == v) return h;
    }
    return {};
}

Edge join(SurfaceMesh& mesh, Face f, Vertex a, Vertex b) {
    return M::edge(insert_edge(mesh, leaving(mesh, a, f), leaving(mesh, b, f)));
}

}  // namespace

bool is_wide_rung(const SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge back = M::twin(h);
    if (mesh.is_constrained(M::edge(h)) || mesh.is_boundary(back)) return false;
    const Face behind = mesh.face(back);
    if (!mesh.is_quad(behind) || mesh.info(behind).row > 0) return false;
    if (!mesh.is_constrained(M::edge(mesh.next(back))) || !mesh.is_constrained(M::edge(mesh.prev(back)))) return false;
    return mesh.length(h) > kWide * 0.5 * (mesh.info(mesh.from(h)).size + mesh.info(mesh.to(h)).size);
}

Face split_rung(SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface* reference) {
    // The edge runs from p to n, the quad behind it is n p s r. Nodes a and b part the edge, c and d lie inside of the quad.
    const HalfEdge back = M::twin(h);
    const Face behind = mesh.face(back);
    const Vertex p = mesh.from(h);
    const Vertex n = mesh.to(h);
    const Vertex s = mesh.to(mesh.next(back));
    const Vertex r = mesh.from(mesh.prev(back));
    const Vertex tip = mesh.to(mesh.next(h));
    std::int32_t hint = -1;
    const auto place = [&](double along, double back_share) -> Point {
        const Point front = mesh.position(p) + along * (mesh.position(n) - mesh.position(p));
        const Point rear = mesh.position(s) + along * (mesh.position(r) - mesh.position(s));
        const Point point = front + back_share * (rear - front);
        return reference ? reference->project(point, mesh.info(behind).patch, hint) : point;
    };
    const Point at_a = place(1.0 / 3.0, 0.0);
    const Point at_c = place(1.0 / 3.0, 0.5);
    const Point at_d = place(2.0 / 3.0, 0.5);
    const Vertex b = insert_vertex(mesh, M::edge(h), place(2.0 / 3.0, 0.0));
    const Vertex a = insert_vertex(mesh, M::edge(mesh.find_halfedge(p, b)), at_a);
    join(mesh, mesh.face(mesh.find_halfedge(p, a)), tip, a);
    join(mesh, mesh.face(mesh.find_halfedge(a, b)), tip, b);
    const Vertex c = insert_vertex(mesh, join(mesh, mesh.face(mesh.find_halfedge(s, r)), s, a), at_c);
    const Vertex d = insert_vertex(mesh, join(mesh, mesh.face(mesh.find_halfedge(s, r)), r, b), at_d);
    join(mesh, mesh.face(mesh.find_halfedge(s, r)), c, d);
    return mesh.face(mesh.find_halfedge(b, a));
}

}  // namespace anisoquad
