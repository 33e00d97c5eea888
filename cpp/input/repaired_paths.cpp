#include "input/repaired_paths.h"

#include <algorithm>

namespace anisoquad {
namespace {

constexpr int kMostHalvings = 40;  // of one edge, one in the other

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A path along both sides of a slit would go to its end and back by the same edges once the slit is welded.
std::vector<std::int32_t> without_spikes(std::span<const std::int32_t> path) {
    std::vector<std::int32_t> result;
    for (const std::int32_t v : path) {
        if (result.size() > 1 && result[result.size() - 2] == v) {
            result.pop_back();
        } else {
            result.push_back(v);
        }
    }
    return result;
}

}  // namespace

RepairedPaths::RepairedPaths(const TriangleSoup& repaired) : soup_(repaired), copies_(repaired.points.size()) {
    for (const auto& t : soup_.triangles) {
        for (std::size_t k = 0; k < 3; ++k) edges_.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
    }
    std::sort(edges_.begin(), edges_.end());
    for (const TriangleSoup::HalvedEdge& halved : soup_.halved)
        middle_.emplace(std::minmax(soup_.root(halved.a), soup_.root(halved.b)), soup_.root(halved.middle));
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(soup_.points.size()); ++v) {
        copies_[at(v)].push_back(v);
        const std::int32_t origin = soup_.origin[at(v)];
        if (origin >= 0 && origin != v) copies_[at(soup_.root(origin))].push_back(v);
    }
}

bool RepairedPaths::joined(std::int32_t a, std::int32_t b) const {
    return std::binary_search(edges_.begin(), edges_.end(), std::pair<std::int32_t, std::int32_t>(std::minmax(a, b)));
}

bool RepairedPaths::joined_somewhere(std::int32_t a, std::int32_t b) const {
    return std::any_of(copies(a).begin(), copies(a).end(), [&](std::int32_t from) {
        return std::any_of(copies(b).begin(), copies(b).end(), [&](std::int32_t to) { return joined(from, to); });
    });
}

/// Appends the way from a (already there) to b.
void RepairedPaths::expand(std::int32_t a, std::int32_t b, int depth, std::vector<std::int32_t>& path) const {
    const auto middle = middle_.find(std::minmax(a, b));
    if (joined_somewhere(a, b) || middle == middle_.end() || middle->second == a || middle->second == b || depth == 0) {
        path.push_back(b);
        return;
    }
    expand(a, middle->second, depth - 1, path);
    expand(middle->second, b, depth - 1, path);
}

std::vector<std::int32_t> RepairedPaths::expanded(std::span<const std::int32_t> vertices) const {
    std::vector<std::int32_t> path;
    for (const std::int32_t v : vertices) {
        const std::int32_t next = soup_.root(v);
        if (path.empty()) {
            path.push_back(next);
        } else if (path.back() != next) {
            expand(path.back(), next, kMostHalvings, path);
        }
    }
    return without_spikes(path);
}

/// Copies of the path's vertices that edges join, from the given copy of the first one; empty if there are none.
std::vector<std::int32_t> RepairedPaths::joined_copies(std::span<const std::int32_t> path, std::int32_t start,
                                                       bool closed) const {
    struct Step {
        std::int32_t vertex;
        std::size_t before;  ///< place in the layer before
    };
    std::vector<std::vector<Step>> layers{{{start, 0}}};
    for (std::size_t i = 1; i < path.size(); ++i) {
        std::vector<Step> layer;
        for (const std::int32_t copy : copies(path[i])) {
            if (closed && i + 1 == path.size() && copy != start) continue;
            const auto& last = layers.back();
            const auto from = std::find_if(last.begin(), last.end(), [&](const Step& s) { return joined(s.vertex, copy); });
            if (from != last.end()) layer.push_back({copy, static_cast<std::size_t>(from - last.begin())});
        }
        if (layer.empty()) return {};
        layers.push_back(std::move(layer));
    }
    std::vector<std::int32_t> result;
    std::size_t place = 0;
    for (std::size_t i = layers.size(); i-- > 0; place = layers[i][place].before) result.push_back(layers[i][place].vertex);
    std::reverse(result.begin(), result.end());
    return result;
}

std::vector<std::int32_t> RepairedPaths::path(std::span<const std::int32_t> vertices) const {
    if (vertices.empty() || !std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t v) { return exists(v); }))
        return {vertices.begin(), vertices.end()};
    const std::vector<std::int32_t> merged = expanded(vertices);
    const bool closed = merged.size() > 1 && merged.front() == merged.back();
    for (const std::int32_t start : copies(merged.front())) {
        std::vector<std::int32_t> found = joined_copies(merged, start, closed);
        if (!found.empty()) return found;
    }
    return merged;
}

std::vector<std::array<std::int32_t, 2>> RepairedPaths::edges(std::span<const std::array<std::int32_t, 2>> pairs) const {
    std::vector<std::array<std::int32_t, 2>> result;
    for (const auto& pair : pairs) {
        const std::size_t before = result.size();
        if (exists(pair[0]) && exists(pair[1])) {
            const std::vector<std::int32_t> path = expanded(pair);
            if (path.size() == 1) continue;  // merged
            for (std::size_t i = 0; i + 1 < path.size(); ++i) {
                for (const std::int32_t a : copies(path[i])) {
                    for (const std::int32_t b : copies(path[i + 1])) {
                        if (joined(a, b)) result.push_back({a, b});
                    }
                }
            }
        }
        if (result.size() == before) result.push_back(pair);
    }
    return result;
}

}  // namespace anisoquad
