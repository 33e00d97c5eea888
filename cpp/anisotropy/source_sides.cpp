#include "anisotropy/source_sides.h"

#include <algorithm>

#include "qmorph/front.h"

namespace anisoquad {
namespace {

/// Cuts the nodes of one side where the front does not run on along the source, and drops what is no front.
void append_stacks(const SurfaceMesh& mesh, const std::vector<Vertex>& nodes, std::int32_t source, bool left,
                   std::vector<RowStack>& stacks) {
    const auto front = [&](std::size_t i) {
        const HalfEdge h = mesh.find_halfedge(nodes[i], nodes[i + 1]);
        return h.is_valid() && is_front(mesh, h) ? h : HalfEdge();
    };
    const std::size_t n = nodes.size() - 1;
    const auto runs_on = [&](std::size_t i, std::size_t j) { return next_front(mesh, front(i)) == front(j); };
    const std::size_t first = stacks.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!front(i).is_valid()) continue;
        const bool continued =
            stacks.size() > first && stacks.back().layers[0].back() == nodes[i] && front(i - 1).is_valid() && runs_on(i - 1, i);
        if (!continued) {
            RowStack stack;
            stack.source = source;
            stack.left = left;
            stack.layers.push_back({nodes[i]});
            stacks.push_back(stack);
        }
        stacks.back().layers[0].push_back(nodes[i + 1]);
    }
    if (stacks.size() == first || nodes.front() != nodes.back()) return;
    // A closed source: the last stack may run on into the first one.
    if (!front(n - 1).is_valid() || !front(0).is_valid() || !runs_on(n - 1, 0)) return;
    if (stacks.size() == first + 1) {
        stacks.back().closed = true;
        return;
    }
    std::vector<Vertex>& head = stacks[first].layers[0];
    std::vector<Vertex>& tail = stacks.back().layers[0];
    tail.insert(tail.end(), head.begin() + 1, head.end());
    head = tail;
    stacks.pop_back();
}

}  // namespace

std::vector<RowStack> source_sides(const SurfaceMesh& mesh, std::span<const Source> sources) {
    std::vector<RowStack> stacks;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        if (sources[s].passes.empty()) continue;
        for (const bool left : {true, false}) {
            if (sources[s].sides == (left ? Sides::right : Sides::left)) continue;
            std::vector<Vertex> nodes;
            for (const std::int32_t v : sources[s].vertices) nodes.emplace_back(v);
            if (!left) std::reverse(nodes.begin(), nodes.end());
            append_stacks(mesh, nodes, static_cast<std::int32_t>(s), left, stacks);
        }
    }
    return stacks;
}

}  // namespace anisoquad
