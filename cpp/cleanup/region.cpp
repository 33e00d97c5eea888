#include "cleanup/region.h"

#include <algorithm>

#include "cleanup/sectors.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

}  // namespace

bool RegionEditor::is_at_cut(Face f) const {
    for (const HalfEdge h : mesh_.halfedges(f)) {
        const HalfEdge out = mesh_.halfedge(mesh_.from(h));
        if (mesh_.is_boundary(out) && (mesh_.info(M::edge(out)).cut || mesh_.info(M::edge(mesh_.prev(out))).cut)) return true;
    }
    return false;
}

bool RegionEditor::trace_outline(Region& region) {
    region.loop.clear();
    region.inner.clear();
    face_marks_.clear(mesh_.face_slots());
    for (const Face f : region.faces) {
        if (!mesh_.is_quad(f) || mesh_.info(f).row > 0 || is_at_cut(f) || !face_marks_.mark(f)) return false;
    }
    HalfEdge start;
    std::size_t border = 0;
    for (const Face f : region.faces) {
        for (const HalfEdge h : mesh_.halfedges(f)) {
            const Face other = mesh_.face(M::twin(h));
            if (!other.is_valid() || !face_marks_.has(other)) {
                start = h;
                ++border;
            } else if (is_fixed(mesh_, M::edge(h))) {
                return false;
            }
        }
    }
    if (!start.is_valid()) return false;
    vertex_marks_.clear(mesh_.vertex_slots());
    HalfEdge h = start;
    do {
        if (!vertex_marks_.mark(mesh_.from(h))) return false;
        region.loop.push_back(h);
        h = mesh_.next(h);
        for (;;) {
            const Face other = mesh_.face(M::twin(h));
            if (!other.is_valid() || !face_marks_.has(other)) break;
            h = mesh_.rotated_cw(h);
        }
    } while (h != start);
    return region.loop.size() == border;
}

bool RegionEditor::find_outline(Region& region) { return trace_outline(region) && find_inner(region); }

bool RegionEditor::find_inner(Region& region) {
    for (const Face f : region.faces) {
        for (const HalfEdge k : mesh_.halfedges(f)) {
            const Vertex v = mesh_.from(k);
            if (!vertex_marks_.mark(v)) continue;
            if (!is_movable(mesh_, v)) return false;
            region.inner.push_back(v);
        }
    }
    const std::size_t inner_edges = (4 * region.faces.size() - region.loop.size()) / 2;
    return region.inner.size() + region.faces.size() == inner_edges + 1;
}

Replacement RegionEditor::current(const Region& region) const {
    Replacement result;
    for (const Vertex v : region.inner) result.nodes.push_back({mesh_.position(v), mesh_.info(v)});
    for (const Face f : region.faces) {
        std::array<Vertex, 4>& quad = result.quads.emplace_back();
        std::size_t k = 0;
        for (const HalfEdge h : mesh_.halfedges(f)) {
            const auto at = std::find(region.inner.begin(), region.inner.end(), mesh_.from(h));
            quad[k++] = at == region.inner.end() ? mesh_.from(h)
                                                 : Replacement::new_node(static_cast<std::size_t>(at - region.inner.begin()));
        }
    }
    return result;
}

bool RegionEditor::is_possible(const Region& region, const Replacement& replacement) {
    face_marks_.clear(mesh_.face_slots());
    for (const Face f : region.faces) face_marks_.mark(f);
    vertex_marks_.clear(mesh_.vertex_slots());
    for (const HalfEdge h : region.loop) vertex_marks_.mark(mesh_.from(h));
    sides_.clear();
    for (const auto& quad : replacement.quads) {
        for (const Vertex v : quad) {
            if (!Replacement::is_new(v) && !vertex_marks_.has(v)) return false;  // it will be gone
        }
        for (std::size_t k = 0; k < 4; ++k) sides_.push_back({quad[k], quad[(k + 1) % 4], {}});
    }
    // Sides in opposite directions become neighbours in this order.
    const auto key = [](const Side& s) { return std::pair(std::min(s.from, s.to), std::max(s.from, s.to)); };
    std::sort(sides_.begin(), sides_.end(), [&](const Side& a, const Side& b) { return key(a) < key(b); });
    static thread_local std::vector<std::pair<Vertex, Vertex>> outline;
    outline.clear();
    for (const HalfEdge h : region.loop) outline.emplace_back(mesh_.from(h), mesh_.to(h));
    std::sort(outline.begin(), outline.end());
    std::size_t covered = 0;
    for (std::size_t i = 0; i < sides_.size();) {
        const Side& s = sides_[i];
        if (s.from == s.to) return false;
        std::size_t same = 1;
        while (i + same < sides_.size() && key(sides_[i + same]) == key(s)) ++same;
        i += same;
        if (same == 1) {
            if (!std::binary_search(outline.begin(), outline.end(), std::pair(s.from, s.to))) return false;
            ++covered;
            continue;
        }
        if (same > 2 || sides_[i - 1].from != s.to) return false;
        if (Replacement::is_new(s.from) || Replacement::is_new(s.to)) continue;
        const HalfEdge h = mesh_.find_halfedge(s.from, s.to);
        if (!h.is_valid()) continue;
        for (const Face f : {mesh_.face(h), mesh_.face(M::twin(h))}) {
            if (!f.is_valid() || !face_marks_.has(f)) return false;
        }
    }
    return covered == outline.size() && !lies_on_another_face(replacement);
}

/// Two quads on the same nodes, which small closed surfaces come to. @pre the region's faces are marked
bool RegionEditor::lies_on_another_face(const Replacement& replacement) const {
    static thread_local std::vector<std::array<Vertex, 4>> quads;
    quads = replacement.quads;
    for (auto& quad : quads) std::sort(quad.begin(), quad.end());
    std::sort(quads.begin(), quads.end());
    if (std::adjacent_find(quads.begin(), quads.end()) != quads.end()) return true;
    for (const auto& quad : quads) {
        if (std::any_of(quad.begin(), quad.end(), Replacement::is_new)) continue;
        for (const HalfEdge out : mesh_.outgoing(quad[0])) {
            const Face f = mesh_.face(out);
            if (!f.is_valid() || face_marks_.has(f)) continue;
            std::size_t same = 0;
            for (const HalfEdge h : mesh_.halfedges(f))
                same += std::binary_search(quad.begin(), quad.end(), mesh_.from(h)) ? 1 : 0;
            if (same == 4) return true;
        }
    }
    return false;
}

void RegionEditor::replace(Region& region, const Replacement& replacement) {
    assert(is_possible(region, replacement));
    const FaceInfo info = mesh_.info(region.faces[0]);
    vertex_marks_.clear(mesh_.vertex_slots());
    for (const HalfEdge h : region.loop) vertex_marks_.mark(mesh_.from(h));
    static thread_local std::vector<Edge> edges;
    edges.clear();
    for (const Face f : region.faces) {
        for (const HalfEdge h : mesh_.halfedges(f)) {
            // Both halves of an inner edge lie inside.
            if (h.index() % 2 == 0 && std::find(region.loop.begin(), region.loop.end(), h) == region.loop.end())
                edges.push_back(M::edge(h));
        }
    }
    // Slots are reused last in, first out: backwards, so that undoing gives faces and nodes their handles back.
    std::for_each(region.faces.rbegin(), region.faces.rend(), [&](Face f) { mesh_.remove(f); });
    for (const Edge e : edges) mesh_.remove(e);
    std::for_each(region.inner.rbegin(), region.inner.rend(), [&](Vertex v) { mesh_.remove(v); });

    new_nodes_.clear();
    for (const Replacement::Node& node : replacement.nodes) {
        new_nodes_.push_back(mesh_.add_vertex(node.place));
        mesh_.info(new_nodes_.back()) = node.info;
    }
    sides_.clear();
    for (const HalfEdge h : region.loop) sides_.push_back({mesh_.from(h), mesh_.to(h), h});
    const auto before = [](const Side& a, const Side& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); };
    std::sort(sides_.begin(), sides_.end(), before);
    const auto outline_end = static_cast<std::ptrdiff_t>(sides_.size());
    for (const auto& quad : replacement.quads) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Side s{handle(quad[k]), handle(quad[(k + 1) % 4]), {}};
            if (std::binary_search(sides_.begin(), sides_.begin() + outline_end, s, before)) continue;
            if (s.from > s.to) continue;  // the other direction comes along
            const HalfEdge h = mesh_.add_edge(s.from, s.to);
            sides_.push_back({s.from, s.to, h});
            sides_.push_back({s.to, s.from, M::twin(h)});
        }
    }
    std::sort(sides_.begin(), sides_.end(), before);
    const auto side = [&](Vertex from, Vertex to) {
        return std::lower_bound(sides_.begin(), sides_.end(), Side{from, to, {}}, before)->halfedge;
    };
    region.faces.clear();
    for (const auto& quad : replacement.quads) {
        const Face f = mesh_.add_face();
        mesh_.info(f) = info;
        region.faces.push_back(f);
        for (std::size_t k = 0; k < 4; ++k) {
            const HalfEdge h = side(handle(quad[k]), handle(quad[(k + 1) % 4]));
            mesh_.link(h, side(handle(quad[(k + 1) % 4]), handle(quad[(k + 2) % 4])));
            mesh_.set_face(h, f);
            mesh_.set_halfedge(f, h);
            if (Replacement::is_new(quad[k])) mesh_.set_halfedge(handle(quad[k]), h);
        }
    }
    for (const HalfEdge h : region.loop) {
        const Vertex v = mesh_.from(h);
        mesh_.set_halfedge(v, h);
        mesh_.adjust_outgoing(v);
    }
    region.inner = new_nodes_;
}

}  // namespace anisoquad
