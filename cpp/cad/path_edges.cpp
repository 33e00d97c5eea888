#include "cad/path_edges.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace anisoquad::cad {

PathEdges::PathEdges(std::span<const EdgePath> paths) {
    for (std::size_t e = 0; e < paths.size(); ++e) {
        const EdgePath& path = paths[e];
        for (std::size_t i = 1; i < path.vertices.size(); ++i) {
            Entry entry{path.vertices[i - 1], path.vertices[i], static_cast<std::int32_t>(e), path.parameters[i - 1],
                        path.parameters[i]};
            if (entry.low > entry.high) {
                std::swap(entry.low, entry.high);
                std::swap(entry.at_low, entry.at_high);
            }
            entries_.push_back(entry);
        }
    }
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return std::tie(a.low, a.high, a.edge) < std::tie(b.low, b.high, b.edge); });
}

std::size_t PathEdges::first(std::int32_t a, std::int32_t b) const {
    const auto found = std::lower_bound(
        entries_.begin(), entries_.end(), std::pair(std::min(a, b), std::max(a, b)),
        [](const Entry& e, const std::pair<std::int32_t, std::int32_t>& key) { return std::pair(e.low, e.high) < key; });
    return static_cast<std::size_t>(found - entries_.begin());
}

PathEdges::Side PathEdges::find(std::int32_t a, std::int32_t b) const {
    const std::size_t i = first(a, b);
    if (i == entries_.size() || !entries_[i].joins(a, b)) return {};
    const Entry* const found = &entries_[i];
    return a == found->low ? Side{found->edge, {found->at_low, found->at_high}}
                           : Side{found->edge, {found->at_high, found->at_low}};
}

}  // namespace anisoquad::cad
