#include "anisotropy/blend_ahead.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "anisotropy/raise_sizes.h"
#include "prepare/remesh.h"
#include "qmorph/front.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr double kGrowth = 0.5;        // of the size away from lines
constexpr double kGrowthAhead = 0.25;  // of the size away from the rows' front

struct Raised {
    double size;
    Vertex v;
    bool operator<(const Raised& other) const { return size != other.size ? size < other.size : v > other.v; }
};

/// Bounds the wanted size near the rows' front and near feature lines, whose nodes are fixed, by their edges' length and a growth
/// with distance.
/// @param on_front per vertex slot, nonzero for nodes of the rows' front
/// @param zone nonzero where lines count; gets the nodes whose size the front bounds
void limit_sizes(SurfaceMesh& mesh, const std::vector<char>& on_front, std::vector<char>& zone) {
    const auto smaller = [](const Raised& a, const Raised& b) { return b < a; };
    std::priority_queue<Raised, std::vector<Raised>, decltype(smaller)> queue(smaller);
    std::vector<char> by_front = on_front;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !(mesh.info(v).size > 0.0)) continue;
        const bool on_line = mesh.info(v).kind != NodeKind::interior && !mesh.info(v).in_row;
        if (on_line || on_front[static_cast<std::size_t>(i)]) queue.push({mesh.info(v).size, v});
    }
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > mesh.info(v).size) continue;
        const bool front = by_front[static_cast<std::size_t>(v.index())];
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            const auto slot = static_cast<std::size_t>(w.index());
            const double allowed = size + (front ? kGrowthAhead : kGrowth) * mesh.length(h);
            if (mesh.info(w).in_row || mesh.info(w).size <= allowed) continue;
            if (front ? mesh.info(w).kind != NodeKind::interior : !zone[slot]) continue;
            mesh.info(w).size = allowed;
            by_front[slot] = front;
            zone[slot] = 1;
            queue.push({allowed, w});
        }
    }
}

}  // namespace

void blend_ahead_of_rows(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context) {
    std::vector<char> zone(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    std::priority_queue<Raised> queue;
    std::vector<char> has_rows;  // per patch: the other patches keep their sizes, although they share nodes on lines
    const auto mark = [&](std::int32_t patch) {
        if (static_cast<std::size_t>(patch) >= has_rows.size()) has_rows.resize(static_cast<std::size_t>(patch) + 1, 0);
        has_rows[static_cast<std::size_t>(patch)] = 1;
    };
    const auto ahead = [&](HalfEdge h) {
        if (mesh.is_boundary(h) || !mesh.is_triangle(mesh.face(h))) return false;
        const auto patch = static_cast<std::size_t>(mesh.info(mesh.face(h)).patch);
        return patch < has_rows.size() && has_rows[patch] != 0;
    };
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge h(i);
        if (mesh.is_deleted(h) || !is_front(mesh, h)) continue;
        const Face behind = mesh.face(M::twin(h));
        if (!behind.is_valid() || mesh.info(behind).row == 0) continue;
        mark(mesh.info(mesh.face(h)).patch);
        for (const Vertex v : {mesh.from(h), mesh.to(h)}) {
            if (mesh.info(v).kind != NodeKind::interior) continue;
            char& is_known = zone[static_cast<std::size_t>(v.index())];
            if (is_known && mesh.length(h) <= mesh.info(v).size) continue;
            is_known = 1;
            mesh.info(v).size = mesh.length(h);
            queue.push({mesh.info(v).size, v});
        }
    }
    const std::vector<char> on_front = zone;
    // Largest first: every node gets the largest size that reaches it.
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size < mesh.info(v).size) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (!ahead(h) && !ahead(M::twin(h))) continue;
            const Vertex w = mesh.to(h);
            const double reaches = size - kFallOff * mesh.length(h);
            if (reaches <= mesh.info(w).size || mesh.info(w).kind != NodeKind::interior || mesh.info(w).in_row) continue;
            mesh.info(w).size = reaches;
            zone[static_cast<std::size_t>(w.index())] = 1;
            queue.push({reaches, w});
        }
    }
    limit_sizes(mesh, on_front, zone);
    // Two rings more, where the rows left small triangles.
    for (int ring = 0; ring < 2; ++ring) {
        const std::vector<char> inner = zone;
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(inner.size()); ++i) {
            if (!inner[static_cast<std::size_t>(i)] || mesh.is_deleted(Vertex(i))) continue;
            for (const HalfEdge h : mesh.outgoing(Vertex(i))) {
                if (ahead(h) || ahead(M::twin(h))) zone[static_cast<std::size_t>(mesh.to(h).index())] = 1;
            }
        }
    }
    remesh_triangles(mesh, zone, reference, {.sweeps = 8, .deviation = 1e-3, .context = &context});
}

}  // namespace anisoquad
