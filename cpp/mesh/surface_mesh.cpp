#include "mesh/surface_mesh.h"

namespace anisoquad {

int SurfaceMesh::valence(Vertex v) const {
    int n = 0;
    for ([[maybe_unused]] HalfEdge h : outgoing(v)) ++n;
    return n;
}

int SurfaceMesh::valence(Face f) const {
    int n = 0;
    for ([[maybe_unused]] HalfEdge h : halfedges(f)) ++n;
    return n;
}

HalfEdge SurfaceMesh::find_halfedge(Vertex a, Vertex b) const {
    const HalfEdge at_a = halfedge(a);
    const HalfEdge at_b = halfedge(b);
    if (!at_a.is_valid() || !at_b.is_valid()) return {};
    // Round both nodes at once, until the one with fewer edges is done: the other may be the hub of a large fan.
    HalfEdge h = at_a;
    HalfEdge g = at_b;
    do {
        if (to(h) == b) return h;
        if (to(g) == a) return twin(g);
        h = rotated_cw(h);
        g = rotated_cw(g);
    } while (h != at_a && g != at_b);
    return {};
}

bool SurfaceMesh::has_face_on(Vertex a, Vertex b, Vertex c, Vertex d) const {
    for (const HalfEdge out : outgoing(a)) {
        if (is_boundary(out)) continue;
        int others = 0;
        for (const HalfEdge h : halfedges(face(out))) others += from(h) == b || from(h) == c || from(h) == d;
        if (others == 3) return true;
    }
    return false;
}

Vertex SurfaceMesh::add_vertex(const Point& p) {
    if (!free_vertices_.empty()) {
        const Vertex v = free_vertices_.back();
        free_vertices_.pop_back();
        points_[at(v)] = p;
        vertex_halfedge_[at(v)] = {};
        vertex_info_[at(v)] = {};
        return v;
    }
    points_.push_back(p);
    vertex_halfedge_.emplace_back();
    vertex_info_.emplace_back();
    return Vertex(vertex_slots() - 1);
}

HalfEdge SurfaceMesh::add_edge(Vertex a, Vertex b) {
    Edge e;
    if (!free_edges_.empty()) {
        e = free_edges_.back();
        free_edges_.pop_back();
    } else {
        halfedges_.emplace_back();
        halfedges_.emplace_back();
        edge_info_.emplace_back();
        e = Edge(edge_slots() - 1);
    }
    halfedges_[at(halfedge(e, 0))] = {a, {}, {}, {}};
    halfedges_[at(halfedge(e, 1))] = {b, {}, {}, {}};
    edge_info_[at(e)] = {};
    return halfedge(e, 0);
}

Face SurfaceMesh::add_face() {
    if (!free_faces_.empty()) {
        const Face f = free_faces_.back();
        free_faces_.pop_back();
        face_halfedge_[at(f)] = {};
        face_info_[at(f)] = {};
        return f;
    }
    face_halfedge_.emplace_back();
    face_info_.emplace_back();
    return Face(face_slots() - 1);
}

void SurfaceMesh::adjust_outgoing(Vertex v) {
    for (HalfEdge h : outgoing(v)) {
        if (is_boundary(h)) {
            set_halfedge(v, h);
            return;
        }
    }
}

void SurfaceMesh::remove(Vertex v) {
    vertex_halfedge_[at(v)] = HalfEdge(kDeleted);
    free_vertices_.push_back(v);
}

void SurfaceMesh::remove(Edge e) {
    halfedges_[at(halfedge(e, 0))].from = Vertex(kDeleted);
    halfedges_[at(halfedge(e, 1))].from = Vertex(kDeleted);
    free_edges_.push_back(e);
}

void SurfaceMesh::remove(Face f) {
    face_halfedge_[at(f)] = HalfEdge(kDeleted);
    free_faces_.push_back(f);
}

void SurfaceMesh::link_boundary() {
    for (std::int32_t i = 0; i < halfedge_slots(); ++i) {
        if (!is_deleted(HalfEdge(i)) && is_boundary(HalfEdge(i))) set_halfedge(from(HalfEdge(i)), HalfEdge(i));
    }
    for (std::int32_t i = 0; i < halfedge_slots(); ++i) {
        if (!is_deleted(HalfEdge(i)) && is_boundary(HalfEdge(i))) link(HalfEdge(i), halfedge(to(HalfEdge(i))));
    }
}

void SurfaceMesh::reserve(std::int32_t vertices, std::int32_t edges, std::int32_t faces) {
    points_.reserve(static_cast<std::size_t>(vertices));
    vertex_halfedge_.reserve(static_cast<std::size_t>(vertices));
    vertex_info_.reserve(static_cast<std::size_t>(vertices));
    halfedges_.reserve(2 * static_cast<std::size_t>(edges));
    edge_info_.reserve(static_cast<std::size_t>(edges));
    face_halfedge_.reserve(static_cast<std::size_t>(faces));
    face_info_.reserve(static_cast<std::size_t>(faces));
}

}  // namespace anisoquad
