#include "parts/division.h"

#include <numeric>

namespace anisoquad {
namespace {

using M = SurfaceMesh;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

Division::Division(const SurfaceMesh& mesh, std::span<const std::int32_t> part_of_face, std::int32_t parts,
                   const Context& context)
    : mesh_(mesh),
      part_of_face_(part_of_face),
      first_(at(parts) + 1, 0),
      faces_(at(mesh.face_count())),
      taken_(at(mesh.halfedge_slots()), -1) {
    const auto for_each_face = [&](auto visit) {
        for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) {
            if (!mesh_.is_deleted(Face(f))) visit(Face(f), at(part_of_face_[at(f)]));
        }
    };
    for_each_face([&](Face, std::size_t part) { ++first_[part + 1]; });
    context.breathe();
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    for_each_face([&](Face f, std::size_t part) { faces_[at(next[part]++)] = f; });
}

bool Division::is_inside(HalfEdge h, std::int32_t part) const {
    const Face f = mesh_.face(h);
    return f.is_valid() && part_of_face_[at(f.index())] == part;
}

Part Division::take(std::int32_t part) {
    Part result;
    SurfaceMesh& mine = result.mesh;
    const std::span<const Face> faces(faces_.data() + first_[at(part)], at(face_count(part)));
    // Triangles have half as many vertices and three halves of their number of edges, quads twice these.
    mine.reserve(face_count(part) / 2, 3 * face_count(part) / 2, face_count(part));

    const auto number_fan = [&](HalfEdge start) {
        const Vertex v = mesh_.from(start);
        const Vertex copy = mine.add_vertex(mesh_.position(v));
        mine.info(copy) = mesh_.info(v);
        result.vertices.push_back(v);
        HalfEdge h = start;
        do {
            taken_[at(h.index())] = copy.index();
            h = mesh_.rotated_ccw(h);
        } while (h != start && is_inside(h, part));
        if (h == start) return;
        for (h = start; is_inside(M::twin(h), part);) {
            h = mesh_.rotated_cw(h);
            taken_[at(h.index())] = copy.index();
        }
    };
    for (const Face f : faces) {
        for (const HalfEdge h : mesh_.halfedges(f)) {
            if (taken_[at(h.index())] < 0) number_fan(h);
        }
    }
    std::vector<HalfEdge> side;  // of one face, in the whole mesh and in the part
    std::vector<HalfEdge> copy;
    std::vector<Vertex> corner;
    for (const Face f : faces) {
        side.clear();
        corner.clear();
        copy.clear();
        for (const HalfEdge h : mesh_.halfedges(f)) {
            side.push_back(h);
            corner.emplace_back(taken_[at(h.index())]);
        }
        const Face mate = mine.add_face();
        mine.info(mate) = mesh_.info(f);
        const std::size_t n = side.size();
        for (std::size_t k = 0; k < n; ++k) {
            const HalfEdge twin = M::twin(side[k]);
            const bool has_mate = is_inside(twin, part);
            if (has_mate && mesh_.face(twin) < f) {  // faces come in their order
                copy.push_back(M::twin(HalfEdge(taken_[at(twin.index())])));
            } else {
                copy.push_back(mine.add_edge(corner[k], corner[(k + 1) % n]));
                EdgeInfo& info = mine.info(M::edge(copy[k]));
                info = mesh_.info(M::edge(side[k]));
                info.cut = !has_mate && !mesh_.is_boundary(twin);
                result.edges.push_back(M::edge(side[k]));
            }
            taken_[at(side[k].index())] = copy[k].index();
            mine.set_face(copy[k], mate);
            mine.set_halfedge(corner[k], copy[k]);
        }
        for (std::size_t k = 0; k < n; ++k) mine.link(copy[k], copy[(k + 1) % n]);
        mine.set_halfedge(mate, copy[0]);
    }
    mine.link_boundary();
    return result;
}

SurfaceMesh join(std::span<const Part> parts, std::int32_t vertex_slots, std::int32_t edge_slots, const Context& context) {
    SurfaceMesh whole;
    std::int32_t vertices = 0;
    std::int32_t edges = 0;
    std::int32_t faces = 0;
    for (const Part& part : parts) {
        vertices += part.mesh.vertex_count();
        edges += part.mesh.edge_count();
        faces += part.mesh.face_count();
    }
    whole.reserve(vertices, edges, faces);
    std::vector<Vertex> border_vertex(at(vertex_slots));
    std::vector<HalfEdge> border_edge(at(edge_slots));  // in the direction in which it was first met
    std::vector<Vertex> vertex;
    std::vector<HalfEdge> halfedge;
    for (const Part& part : parts) {
        const SurfaceMesh& mine = part.mesh;
        const auto joined = [&](HalfEdge h) {
            const HalfEdge even = halfedge[at(h.index() / 2)];
            return h.index() % 2 == 0 ? even : M::twin(even);
        };
        context.breathe();
        vertex.assign(at(mine.vertex_slots()), {});
        for (std::int32_t i = 0; i < mine.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mine.is_deleted(v) || !mine.halfedge(v).is_valid()) continue;
            Vertex* const shared = mine.is_boundary(v) ? &border_vertex[at(part.vertices[at(i)].index())] : nullptr;
            Vertex& mate = vertex[at(i)];
            if (shared) mate = *shared;
            if (mate.is_valid()) continue;
            mate = whole.add_vertex(mine.position(v));
            whole.info(mate) = mine.info(v);
            if (shared) *shared = mate;
        }
        halfedge.assign(at(mine.edge_slots()), {});
        for (std::int32_t i = 0; i < mine.edge_slots(); ++i) {
            const Edge e(i);
            if (mine.is_deleted(e)) continue;
            const HalfEdge h = M::halfedge(e);
            const Vertex from = vertex[at(mine.from(h).index())];
            const Vertex to = vertex[at(mine.to(h).index())];
            HalfEdge* const shared = mine.is_boundary(e) ? &border_edge[at(part.edges[at(i)].index())] : nullptr;
            HalfEdge& mate = halfedge[at(i)];
            if (shared && shared->is_valid()) {
                // The face of the other part lies on its other side.
                const bool first_has_face = !whole.is_boundary(*shared);
                const bool mine_has_face = !mine.is_boundary(h);
                mate = first_has_face != mine_has_face ? *shared : M::twin(*shared);
                assert(whole.from(mate) == from && whole.to(mate) == to);
                continue;
            }
            mate = whole.add_edge(from, to);
            whole.info(M::edge(mate)) = mine.info(e);
            whole.info(M::edge(mate)).cut = false;
            if (shared) *shared = mate;
        }
        for (std::int32_t i = 0; i < mine.face_slots(); ++i) {
            const Face f(i);
            if (mine.is_deleted(f)) continue;
            const Face mate = whole.add_face();
            whole.info(mate) = mine.info(f);
            for (const HalfEdge h : mine.halfedges(f)) {
                const HalfEdge k = joined(h);
                whole.set_face(k, mate);
                whole.set_halfedge(whole.from(k), k);
                whole.link(k, joined(mine.next(h)));
            }
            whole.set_halfedge(mate, joined(mine.halfedge(f)));
        }
    }
    context.breathe();
    whole.link_boundary();
    return whole;
}

}  // namespace anisoquad
