#include "anisotropy/raise_sizes.h"

#include <queue>
#include <utility>

namespace anisoquad {

std::vector<char> raise_sizes(SurfaceMesh& mesh, std::span<const double> length) {
    std::vector<char> raised(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    // Largest first: every node gets the largest size that reaches it.
    std::priority_queue<std::pair<double, Vertex>> queue;
    for (std::size_t i = 0; i < length.size(); ++i) {
        if (length[i] > 0.0) queue.emplace(length[i], static_cast<std::int32_t>(i));
    }
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            const double reaches = size - kFallOff * mesh.length(h);
            if (reaches <= mesh.info(w).size || mesh.info(w).kind != NodeKind::interior || mesh.info(w).in_row) continue;
            mesh.info(w).size = reaches;
            raised[static_cast<std::size_t>(w.index())] = 1;
            queue.emplace(reaches, w);
        }
    }
    return raised;
}

}  // namespace anisoquad
