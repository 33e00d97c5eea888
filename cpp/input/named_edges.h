#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// The edges that the user named, those of sources and of Options::feature_edges, which no mending of the input touches.
class NamedEdges {
  public:
    NamedEdges(std::span<const Source> sources, const Options& options) : edges_(options.feature_edges) {
        for (const Source& source : sources) {
            for (std::size_t i = 1; i < source.vertices.size(); ++i)
                edges_.push_back({source.vertices[i - 1], source.vertices[i]});
        }
        for (auto& edge : edges_) {
            std::sort(edge.begin(), edge.end());
            vertices_.insert(vertices_.end(), edge.begin(), edge.end());
        }
        std::sort(edges_.begin(), edges_.end());
        std::sort(vertices_.begin(), vertices_.end());
    }

    bool contains(const SurfaceMesh& mesh, HalfEdge h) const {
        const auto [low, high] = std::minmax({mesh.from(h).index(), mesh.to(h).index()});
        return std::binary_search(edges_.begin(), edges_.end(), std::array{low, high});
    }
    /// True for an end of one of the edges.
    bool touch(Vertex v) const { return std::binary_search(vertices_.begin(), vertices_.end(), v.index()); }

  private:
    std::vector<std::array<std::int32_t, 2>> edges_;  ///< each with its lower vertex first, sorted
    std::vector<std::int32_t> vertices_;              ///< sorted
};

}  // namespace anisoquad
