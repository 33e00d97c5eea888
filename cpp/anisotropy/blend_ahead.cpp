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

constexpr double kGrowth = 0.5;  // of the size away from lines, whose nodes are fixed

struct Raised {
    double size;
    Vertex v;
    bool operator<(const Raised& other) const { return size != other.size ? size < other.size : v > other.v; }
};

/// Bounds the wanted size near feature lines, which keep their nodes, by their edges' length and a growth with distance.
void limit_near_lines(SurfaceMesh& mesh, const std::vector<char>& zone) {
    const auto smaller = [](const Raised& a, const Raised& b) { return b < a; };
    std::priority_queue<Raised, std::vector<Raised>, decltype(smaller)> queue(smaller);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || mesh.info(v).kind == NodeKind::interior || !(mesh.info(v).size > 0.0) || mesh.info(v).in_row)
            continue;
        queue.push({mesh.info(v).size, v});
    }
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > mesh.info(v).size) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            const double allowed = size + kGrowth * mesh.length(h);
            if (!zone[static_cast<std::size_t>(w.index())] || mesh.info(w).in_row || mesh.info(w).size <= allowed) continue;
            mesh.info(w).size = allowed;
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
            if (mesh.length(h) > mesh.info(v).size || !zone[static_cast<std::size_t>(v.index())]) {
                mesh.info(v).size = std::max(mesh.info(v).size, mesh.length(h));
                queue.push({mesh.info(v).size, v});
            }
            zone[static_cast<std::size_t>(v.index())] = 1;
        }
    }
    // Largest first: every node gets the largest size that reaches it.
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size < mesh.info(v).size) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (!ahead(h) && !ahead(M::twin(h))) continue;
            const Vertex w = mesh.to(h);
            const double reaches = size - kFallOff * mesh.length(h);
            if (reaches <= mesh.info(w).size || mesh.info(w).kind != NodeKind::interior) continue;
            mesh.info(w).size = reaches;
            zone[static_cast<std::size_t>(w.index())] = 1;
            queue.push({reaches, w});
        }
    }
    limit_near_lines(mesh, zone);
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
