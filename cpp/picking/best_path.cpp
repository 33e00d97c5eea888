#include "picking/best_path.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <string>

#include "errors.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

// How much less a length counts. A boundary is followed when it is near, but is no reason for a long way round.
constexpr double kRidgeGain = 4.0;
constexpr double kBoundaryGain = 0.5;

double cost(const PickSurface& surface, Edge e) {
    if (surface.mesh.is_boundary(e)) return surface.mesh.length(e) / (1.0 + kBoundaryGain);
    const double curvature = std::max(surface.curvature[static_cast<std::size_t>(e.index())], 0.0);
    const double ridge = surface.mesh.info(e).line >= 0 ? 1.0 : curvature / (curvature + 4.0 * surface.mean_curvature);
    return surface.mesh.length(e) / (1.0 + kRidgeGain * ridge);
}

void check_vertex(const PickSurface& surface, std::int32_t v) {
    if (v < 0 || v >= surface.mesh.vertex_slots())
        throw Error(ErrorCode::index_out_of_range, "The mesh has no point " + std::to_string(v) + ".", ElementKind::vertex, {v});
}

}  // namespace

std::vector<std::int32_t> best_path(const PickSurface& surface, std::int32_t from, std::int32_t to) {
    check_vertex(surface, from);
    check_vertex(surface, to);
    const SurfaceMesh& mesh = surface.mesh;
    const auto count = static_cast<std::size_t>(mesh.vertex_slots());
    std::vector<double> way(count, std::numeric_limits<double>::infinity());
    std::vector<Vertex> before(count);
    using Entry = std::pair<double, std::int32_t>;  // equal ways in the order of the indices
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    way[static_cast<std::size_t>(from)] = 0.0;
    queue.emplace(0.0, from);
    while (!queue.empty()) {
        const auto [reached, index] = queue.top();
        queue.pop();
        if (index == to) break;
        if (reached > way[static_cast<std::size_t>(index)]) continue;
        for (const HalfEdge h : mesh.outgoing(Vertex(index))) {
            const auto next = static_cast<std::size_t>(mesh.to(h).index());
            const double sum = reached + cost(surface, M::edge(h));
            if (sum >= way[next]) continue;
            way[next] = sum;
            before[next] = Vertex(index);
            queue.emplace(sum, mesh.to(h).index());
        }
    }
    std::vector<std::int32_t> path;
    if (way[static_cast<std::size_t>(to)] == std::numeric_limits<double>::infinity()) return path;
    for (Vertex v(to); v.is_valid(); v = before[static_cast<std::size_t>(v.index())]) path.push_back(v.index());
    std::reverse(path.begin(), path.end());
    return path;
}

}  // namespace anisoquad
