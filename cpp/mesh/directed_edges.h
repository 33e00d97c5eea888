#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace anisoquad {

/// One directed edge of a facet.
struct DirectedEdge {
    std::int32_t low;     ///< lower vertex
    std::int32_t high;    ///< higher vertex
    std::int32_t corner;  ///< 3·facet + corner; the edge leaves that corner for the next one of the facet
    bool same_edge(const DirectedEdge& other) const { return low == other.low && high == other.high; }
};

/// The directed edges of all facets, so that those between the same two vertices stand together: by lower vertex, then by
/// higher one, then by corner.
/// @pre every index is in 0 … points − 1
std::vector<DirectedEdge> sorted_edges(std::size_t points, std::span<const std::array<std::int32_t, 3>> triangles);

/// Calls f(group) with a span of the directed edges between the same two vertices, for all edges in order.
template <class Function>
void for_each_edge(std::span<const DirectedEdge> sorted, Function f) {
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t j = i + 1;
        while (j < sorted.size() && sorted[i].same_edge(sorted[j])) ++j;
        f(sorted.subspan(i, j - i));
        i = j;
    }
}

/// The corners of the same facet before and after a corner (3·facet + corner).
constexpr std::int32_t next_corner(std::int32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
constexpr std::int32_t previous_corner(std::int32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

}  // namespace anisoquad
