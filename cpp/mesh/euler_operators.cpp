#include "mesh/euler_operators.h"

#include <algorithm>

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// Of two edges that become one, the info that survives.
EdgeInfo merged(const EdgeInfo& a, const EdgeInfo& b) { return a.line >= 0 ? EdgeInfo{a.line, a.source || b.source} : b; }

/// Removes a face of two edges: its edges become one, the edge of `h`.
void remove_two_gon(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge g = mesh.next(h);
    assert(mesh.next(g) == h && M::edge(g) != M::edge(h));
    const HalfEdge outside = M::twin(g);
    const Face f = mesh.face(h);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.from(g);
    // h takes the place of g's twin, which runs in the same direction as h.
    const Face f_outside = mesh.face(outside);
    assert(mesh.next(outside) != M::twin(h));  // a dangling pair cannot occur in a manifold mesh
    mesh.link(mesh.prev(outside), h);
    mesh.link(h, mesh.next(outside));
    mesh.set_face(h, f_outside);
    if (f_outside.is_valid() && mesh.halfedge(f_outside) == outside) mesh.set_halfedge(f_outside, h);
    mesh.info(M::edge(h)) = merged(mesh.info(M::edge(h)), mesh.info(M::edge(g)));
    mesh.set_halfedge(a, h);
    mesh.set_halfedge(b, M::twin(h));
    mesh.remove(M::edge(g));
    mesh.remove(f);
    mesh.adjust_outgoing(a);
    mesh.adjust_outgoing(b);
}

}  // namespace

bool is_flip_ok(const SurfaceMesh& mesh, Edge e) {
    if (mesh.is_constrained(e)) return false;
    const HalfEdge h = M::halfedge(e);
    const HalfEdge g = M::twin(h);
    if (!mesh.is_triangle(mesh.face(h)) || !mesh.is_triangle(mesh.face(g))) return false;
    const Vertex a = mesh.from(mesh.prev(h));
    const Vertex b = mesh.from(mesh.prev(g));
    return a != b && !mesh.find_halfedge(a, b).is_valid();
}

void flip(SurfaceMesh& mesh, Edge e) {
    const HalfEdge h = M::halfedge(e);
    const HalfEdge g = M::twin(h);
    const HalfEdge h1 = mesh.next(h);
    const HalfEdge h2 = mesh.next(h1);
    const HalfEdge g1 = mesh.next(g);
    const HalfEdge g2 = mesh.next(g1);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.from(g);
    const Face fh = mesh.face(h);
    const Face fg = mesh.face(g);
    mesh.set_from(h, mesh.from(g2));
    mesh.set_from(g, mesh.from(h2));
    mesh.link(h, h2);
    mesh.link(h2, g1);
    mesh.link(g1, h);
    mesh.link(g, g2);
    mesh.link(g2, h1);
    mesh.link(h1, g);
    mesh.set_face(g1, fh);
    mesh.set_face(h1, fg);
    mesh.set_halfedge(fh, h);
    mesh.set_halfedge(fg, g);
    if (mesh.halfedge(a) == h) mesh.set_halfedge(a, g1);
    if (mesh.halfedge(b) == g) mesh.set_halfedge(b, h1);
}

Vertex insert_vertex(SurfaceMesh& mesh, Edge e, const Point& p) {
    const HalfEdge h = M::halfedge(e);
    const HalfEdge g = M::twin(h);
    const Vertex b = mesh.to(h);
    const Vertex v = mesh.add_vertex(p);
    const HalfEdge h_new = mesh.add_edge(v, b);  // v → b, after h
    const HalfEdge g_new = M::twin(h_new);       // b → v, before g
    mesh.info(M::edge(h_new)) = mesh.info(e);
    mesh.info(v).size = 0.5 * (mesh.info(mesh.from(h)).size + mesh.info(b).size);
    if (mesh.info(e).line >= 0) {
        mesh.info(v).line = mesh.info(e).line;
        mesh.info(v).kind = NodeKind::line;
    }
    mesh.link(h_new, mesh.next(h));
    mesh.link(h, h_new);
    mesh.link(mesh.prev(g), g_new);
    mesh.link(g_new, g);
    mesh.set_from(g, v);
    mesh.set_face(h_new, mesh.face(h));
    mesh.set_face(g_new, mesh.face(g));
    if (mesh.halfedge(b) == g) mesh.set_halfedge(b, g_new);
    mesh.set_halfedge(v, mesh.is_boundary(g) ? g : h_new);
    return v;
}

Vertex split_edge(SurfaceMesh& mesh, Edge e, const Point& p) {
    const Vertex v = insert_vertex(mesh, e, p);
    const HalfEdge h = M::halfedge(e);
    const HalfEdge ahead = mesh.next(h);  // v → b
    const HalfEdge back = M::twin(h);     // v → a
    for (const HalfEdge out : {ahead, back}) {
        if (mesh.is_boundary(out)) continue;
        assert(mesh.valence(mesh.face(out)) == 4);
        insert_edge(mesh, out, mesh.next(mesh.next(out)));
    }
    return v;
}

Vertex split_face(SurfaceMesh& mesh, Face f, const Point& p) {
    const Vertex v = mesh.add_vertex(p);
    const FaceInfo info = mesh.info(f);
    const HalfEdge first = mesh.halfedge(f);
    // The face becomes the triangle of its first half-edge; every other half-edge gets a new one.
    HalfEdge h = first;
    HalfEdge spoke = mesh.add_edge(mesh.from(first), v);  // node → v
    const HalfEdge first_spoke = spoke;
    do {
        const HalfEdge following = mesh.next(h);
        const HalfEdge end_spoke = following == first ? first_spoke : mesh.add_edge(mesh.from(following), v);
        const Face face = h == first ? f : mesh.add_face();
        mesh.info(face) = info;
        mesh.link(h, end_spoke);
        mesh.link(end_spoke, M::twin(spoke));
        mesh.link(M::twin(spoke), h);
        for (const HalfEdge side : {h, end_spoke, M::twin(spoke)}) mesh.set_face(side, face);
        mesh.set_halfedge(face, h);
        spoke = end_spoke;
        h = following;
    } while (h != first);
    mesh.set_halfedge(v, M::twin(first_spoke));
    double size = 0.0;
    int sides = 0;
    for (const HalfEdge out : mesh.outgoing(v)) {
        size += mesh.info(mesh.to(out)).size;
        ++sides;
    }
    mesh.info(v).size = size / sides;
    return v;
}

HalfEdge insert_edge(SurfaceMesh& mesh, HalfEdge h, HalfEdge g) {
    assert(mesh.face(h) == mesh.face(g) && h != g);
    const Face f = mesh.face(h);
    const HalfEdge d = mesh.add_edge(mesh.from(h), mesh.from(g));
    const HalfEdge t = M::twin(d);
    const HalfEdge before_h = mesh.prev(h);
    const HalfEdge before_g = mesh.prev(g);
    mesh.link(before_h, d);
    mesh.link(d, g);
    mesh.link(before_g, t);
    mesh.link(t, h);
    const Face f_new = mesh.add_face();
    mesh.info(f_new) = mesh.info(f);
    HalfEdge k = d;
    do {
        mesh.set_face(k, f_new);
        k = mesh.next(k);
    } while (k != d);
    mesh.set_face(t, f);
    mesh.set_halfedge(f, t);
    mesh.set_halfedge(f_new, d);
    return d;
}

Face dissolve_edge(SurfaceMesh& mesh, Edge e) {
    const HalfEdge h = M::halfedge(e);
    const HalfEdge g = M::twin(h);
    const Face f = mesh.face(h);
    const Face gone = mesh.face(g);
    assert(f.is_valid() && gone.is_valid() && f != gone);
    for (HalfEdge k = mesh.next(g); k != g; k = mesh.next(k)) mesh.set_face(k, f);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.from(g);
    const HalfEdge after_h = mesh.next(h);
    const HalfEdge after_g = mesh.next(g);
    mesh.link(mesh.prev(h), after_g);
    mesh.link(mesh.prev(g), after_h);
    mesh.set_halfedge(f, after_h);
    if (mesh.halfedge(a) == h) mesh.set_halfedge(a, after_g);
    if (mesh.halfedge(b) == g) mesh.set_halfedge(b, after_h);
    mesh.remove(gone);
    mesh.remove(e);
    return f;
}

HalfEdge dissolve_vertex(SurfaceMesh& mesh, HalfEdge h) {
    const Vertex v = mesh.to(h);
    const HalfEdge ahead = mesh.next(h);  // v → b, removed
    const HalfEdge g = M::twin(h);        // v → a
    const HalfEdge g_before = M::twin(ahead);
    assert(mesh.next(g_before) == g);
    const Vertex b = mesh.to(ahead);
    mesh.info(M::edge(h)) = merged(mesh.info(M::edge(h)), mesh.info(M::edge(ahead)));
    mesh.set_from(g, b);
    mesh.link(h, mesh.next(ahead));
    mesh.link(mesh.prev(g_before), g);
    if (mesh.face(h).is_valid()) mesh.set_halfedge(mesh.face(h), h);
    if (mesh.face(g).is_valid()) mesh.set_halfedge(mesh.face(g), g);
    if (mesh.halfedge(b) == g_before) mesh.set_halfedge(b, g);
    mesh.remove(M::edge(ahead));
    mesh.remove(v);
    mesh.adjust_outgoing(b);
    return h;
}

bool is_collapse_ok(const SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge g = M::twin(h);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.to(h);
    // A boundary node goes along the boundary only, or the boundary would touch itself.
    if (mesh.is_boundary(a) && mesh.is_boundary(b) && !mesh.is_boundary(M::edge(h))) return false;
    // A triangle of the boundary would close, and a triangle whose other two edges are boundary would vanish.
    int triangles = 0;
    for (const HalfEdge side : {h, g}) {
        if (mesh.prev(side) != mesh.next(mesh.next(side))) continue;
        if (mesh.is_boundary(side)) return false;
        const bool first = mesh.is_boundary(M::twin(mesh.next(side)));
        const bool second = mesh.is_boundary(M::twin(mesh.prev(side)));
        if (first && second) return false;
        ++triangles;
    }
    // Common neighbours are the apexes of the triangles only.
    int common = 0;
    for (const HalfEdge out : mesh.outgoing(a)) {
        if (mesh.to(out) != b && mesh.find_halfedge(mesh.to(out), b).is_valid()) ++common;
    }
    if (common != triangles) return false;
    // On a tetrahedron, or what quads make like it, the faces left would lie on each other.
    if (!mesh.is_boundary(a) && !mesh.is_boundary(b) && mesh.valence(a) + mesh.valence(b) - 2 - triangles < 3) return false;
    // A quad beside a with b as its opposite node would be folded onto itself.
    for (const HalfEdge out : mesh.outgoing(a)) {
        const Face f = mesh.face(out);
        if (!f.is_valid() || f == mesh.face(h) || f == mesh.face(g)) continue;
        for (const HalfEdge k : mesh.halfedges(f)) {
            if (mesh.from(k) == b) return false;
        }
    }
    return true;
}

void collapse(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge g = M::twin(h);
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.to(h);
    static thread_local std::vector<HalfEdge> spokes;
    spokes.clear();
    for (const HalfEdge out : mesh.outgoing(a)) spokes.push_back(out);
    for (const HalfEdge out : spokes) mesh.set_from(out, b);
    const HalfEdge after_h = mesh.next(h);
    const HalfEdge before_g = mesh.prev(g);
    mesh.link(mesh.prev(h), after_h);
    mesh.link(before_g, mesh.next(g));
    if (mesh.face(h).is_valid()) mesh.set_halfedge(mesh.face(h), after_h);
    if (mesh.face(g).is_valid()) mesh.set_halfedge(mesh.face(g), before_g);
    mesh.set_halfedge(b, after_h);
    mesh.remove(M::edge(h));
    mesh.remove(a);
    mesh.adjust_outgoing(b);
    // Of two edges that become one, the one that was at b already stays.
    for (const HalfEdge side : {after_h, before_g}) {
        if (!mesh.is_deleted(side) && mesh.face(side).is_valid() && mesh.next(mesh.next(side)) == side)
            remove_two_gon(mesh, side);
    }
}

bool collect_region(const SurfaceMesh& mesh, std::span<const HalfEdge> loop, std::vector<Face>& faces, std::size_t limit) {
    faces.clear();
    const auto on_loop = [&](HalfEdge h) { return std::find(loop.begin(), loop.end(), h) != loop.end(); };
    const auto known = [&](Face f) { return std::find(faces.begin(), faces.end(), f) != faces.end(); };
    const Face first = mesh.face(loop[0]);
    if (!first.is_valid()) return false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (mesh.from(loop[i]) == mesh.from(loop[k])) return false;  // the loop touches itself
        }
    }
    faces.push_back(first);
    std::size_t interior_halfedges = 0;
    static thread_local std::vector<Vertex> inner;
    inner.clear();
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!mesh.is_triangle(faces[i])) return false;
        for (const HalfEdge h : mesh.halfedges(faces[i])) {
            const Vertex v = mesh.from(h);
            const bool loop_node = std::any_of(loop.begin(), loop.end(), [&](HalfEdge k) { return mesh.from(k) == v; });
            if (!loop_node && std::find(inner.begin(), inner.end(), v) == inner.end()) inner.push_back(v);
            if (on_loop(h)) continue;
            if (on_loop(M::twin(h)) || mesh.is_constrained(M::edge(h))) return false;
            ++interior_halfedges;
            const Face neighbour = mesh.face(M::twin(h));
            if (!known(neighbour)) {
                if (faces.size() >= limit) return false;
                faces.push_back(neighbour);
            }
        }
    }
    for (const HalfEdge h : loop) {
        if (!known(mesh.face(h))) return false;
    }
    for (const Vertex v : inner) {
        if (mesh.info(v).kind != NodeKind::interior || mesh.is_boundary(v)) return false;
    }
    return faces.size() + inner.size() == interior_halfedges / 2 + 1;
}

Face replace_region(SurfaceMesh& mesh, std::span<const HalfEdge> loop, std::span<const Face> faces) {
    static thread_local std::vector<Edge> edges;
    static thread_local std::vector<Vertex> nodes;
    edges.clear();
    nodes.clear();
    const FaceInfo info = mesh.info(faces[0]);
    for (const Face f : faces) {
        for (const HalfEdge h : mesh.halfedges(f)) {
            if (std::find(loop.begin(), loop.end(), h) != loop.end()) continue;
            if (h.index() % 2 == 0) edges.push_back(M::edge(h));  // every inner edge has both halves inside
            const Vertex v = mesh.from(h);
            const bool loop_node = std::any_of(loop.begin(), loop.end(), [&](HalfEdge k) { return mesh.from(k) == v; });
            if (!loop_node && std::find(nodes.begin(), nodes.end(), v) == nodes.end()) nodes.push_back(v);
        }
    }
    for (const Face f : faces) mesh.remove(f);
    for (const Edge e : edges) mesh.remove(e);
    for (const Vertex v : nodes) mesh.remove(v);
    const Face f = mesh.add_face();
    mesh.info(f) = info;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        mesh.link(loop[i], loop[(i + 1) % loop.size()]);
        mesh.set_face(loop[i], f);
        const Vertex v = mesh.from(loop[i]);
        const HalfEdge out = mesh.halfedge(v);
        if (mesh.is_deleted(out) || !mesh.is_boundary(out)) mesh.set_halfedge(v, loop[i]);
    }
    mesh.set_halfedge(f, loop[0]);
    for (const HalfEdge h : loop) mesh.adjust_outgoing(mesh.from(h));
    return f;
}

}  // namespace anisoquad
