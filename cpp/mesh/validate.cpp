#include "mesh/validate.h"

#include <algorithm>
#include <array>

#include "mesh/face_components.h"

namespace anisoquad {

Topology topology(const SurfaceMesh& mesh) {
    Topology result;
    const auto any = [](auto) { return true; };
    result.components = face_components(mesh, any, any).count();
    std::vector<char> seen(static_cast<std::size_t>(mesh.halfedge_slots()), 0);
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        HalfEdge h(i);
        if (mesh.is_deleted(h) || !mesh.is_boundary(h) || seen[static_cast<std::size_t>(i)]) continue;
        ++result.boundary_loops;
        for (; !seen[static_cast<std::size_t>(h.index())]; h = mesh.next(h)) seen[static_cast<std::size_t>(h.index())] = 1;
    }
    std::int32_t vertices = 0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        vertices += !mesh.is_deleted(Vertex(i)) && mesh.halfedge(Vertex(i)).is_valid();
    }
    result.euler_characteristic = vertices - mesh.edge_count() + mesh.face_count();
    return result;
}

namespace {

class Checker {
  public:
    Checker(const SurfaceMesh& mesh, std::size_t most) : mesh_(mesh), most_(most) {}

    std::vector<std::string> run() {
        for (std::int32_t i = 0; i < mesh_.halfedge_slots() && !full(); ++i) check_halfedge(HalfEdge(i));
        for (std::int32_t i = 0; i < mesh_.vertex_slots() && !full(); ++i) check_vertex(Vertex(i));
        for (std::int32_t i = 0; i < mesh_.face_slots() && !full(); ++i) check_face(Face(i));
        if (!full()) check_double_edges();
        if (!full()) check_duplicates();
        return defects_;
    }

  private:
    bool full() const { return defects_.size() >= most_; }
    void add(const std::string& text, std::int32_t index) { defects_.push_back(text + " " + std::to_string(index)); }

    void check_halfedge(HalfEdge h) {
        if (mesh_.is_deleted(h)) return;
        if (!mesh_.next(h).is_valid() || !mesh_.prev(h).is_valid()) return add("unlinked half-edge", h.index());
        if (mesh_.is_deleted(mesh_.next(h))) return add("deleted successor of half-edge", h.index());
        if (mesh_.prev(mesh_.next(h)) != h) add("next and prev disagree at half-edge", h.index());
        if (mesh_.from(mesh_.next(h)) != mesh_.to(h)) add("successor starts elsewhere at half-edge", h.index());
        if (mesh_.face(mesh_.next(h)) != mesh_.face(h)) add("successor has another face at half-edge", h.index());
        if (mesh_.from(h) == mesh_.to(h)) add("half-edge joins a node to itself", h.index());
        if (mesh_.is_deleted(mesh_.from(h))) add("deleted node at half-edge", h.index());
        if (mesh_.is_boundary(h) && mesh_.is_boundary(SurfaceMesh::twin(h))) add("no face beside half-edge", h.index());
        if (mesh_.face(h).is_valid() && mesh_.is_deleted(mesh_.face(h))) add("deleted face at half-edge", h.index());
    }

    void check_vertex(Vertex v) {
        if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid()) return;
        if (mesh_.is_deleted(mesh_.halfedge(v)) || mesh_.from(mesh_.halfedge(v)) != v)
            return add("wrong outgoing half-edge of node", v.index());
        int steps = 0;
        int boundaries = 0;
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (mesh_.from(h) != v || ++steps > mesh_.edge_slots()) return add("broken fan of node", v.index());
            boundaries += mesh_.is_boundary(h);
        }
        if (boundaries > 1) add("more than one fan at node", v.index());
        if (boundaries == 1 && !mesh_.is_boundary(mesh_.halfedge(v)))
            add("outgoing half-edge not on the boundary at node", v.index());
        if (!mesh_.position(v).allFinite()) add("non-finite position of node", v.index());
    }

    void check_face(Face f) {
        if (mesh_.is_deleted(f)) return;
        if (mesh_.is_deleted(mesh_.halfedge(f)) || mesh_.face(mesh_.halfedge(f)) != f)
            return add("wrong half-edge of face", f.index());
        std::array<Vertex, 4> nodes;
        std::size_t n = 0;
        for (const HalfEdge h : mesh_.halfedges(f)) {
            if (n == 4) return add("more than four nodes in face", f.index());
            if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(n), mesh_.from(h)) !=
                nodes.begin() + static_cast<std::ptrdiff_t>(n)) {
                return add("repeated node in face", f.index());
            }
            nodes[n++] = mesh_.from(h);
        }
        if (n < 3) add("fewer than three nodes in face", f.index());
    }

    void check_double_edges() {
        std::vector<std::array<std::int32_t, 3>> keys;
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (mesh_.is_deleted(Edge(i))) continue;
            const HalfEdge h = SurfaceMesh::halfedge(Edge(i));
            const std::int32_t a = mesh_.from(h).index();
            const std::int32_t b = mesh_.to(h).index();
            keys.push_back({std::min(a, b), std::max(a, b), i});
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 0; i + 1 < keys.size() && !full(); ++i) {
            if (keys[i][0] == keys[i + 1][0] && keys[i][1] == keys[i + 1][1])
                add("second edge between the same nodes: edge", keys[i + 1][2]);
        }
    }

    void check_duplicates() {
        std::vector<std::array<std::int32_t, 5>> keys;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            if (mesh_.is_deleted(Face(i))) continue;
            std::array<std::int32_t, 5> key{-1, -1, -1, -1, i};
            std::size_t n = 0;
            for (const HalfEdge h : mesh_.halfedges(Face(i))) key[n++] = mesh_.from(h).index();
            std::sort(key.begin(), key.begin() + 4);
            keys.push_back(key);
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 0; i + 1 < keys.size() && !full(); ++i) {
            if (std::equal(keys[i].begin(), keys[i].begin() + 4, keys[i + 1].begin())) add("duplicate face", keys[i + 1][4]);
        }
    }

    const SurfaceMesh& mesh_;
    std::size_t most_;
    std::vector<std::string> defects_;
};

}  // namespace

std::vector<std::string> validate(const SurfaceMesh& mesh, std::size_t most) { return Checker(mesh, most).run(); }

}  // namespace anisoquad
