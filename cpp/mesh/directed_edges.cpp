#include "mesh/directed_edges.h"

#include <algorithm>

namespace anisoquad {

std::vector<DirectedEdge> sorted_edges(std::size_t points, std::span<const std::array<std::int32_t, 3>> triangles) {
    // A counting sort by the lower end leaves only short runs to sort.
    std::vector<std::int32_t> start(points + 1, 0);
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++start[static_cast<std::size_t>(std::min(t[k], t[(k + 1) % 3])) + 1];
    }
    for (std::size_t i = 0; i < points; ++i) start[i + 1] += start[i];
    std::vector<DirectedEdge> edges(3 * triangles.size());
    std::vector<std::int32_t> fill(start.begin(), start.end() - 1);
    std::int32_t corner = 0;
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            edges[static_cast<std::size_t>(fill[static_cast<std::size_t>(low)]++)] = {low, high, corner++};
        }
    }
    const auto before = [](const DirectedEdge& a, const DirectedEdge& b) {
        return a.high != b.high ? a.high < b.high : a.corner < b.corner;
    };
    for (std::size_t i = 0; i < points; ++i) std::sort(edges.begin() + start[i], edges.begin() + start[i + 1], before);
    return edges;
}

}  // namespace anisoquad
