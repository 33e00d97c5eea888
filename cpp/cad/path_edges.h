#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/edge_paths.h"

namespace anisoquad::cad {

/// Which CAD edge each mesh edge lies on, if any, by its two vertices.
class PathEdges {
  public:
    struct Side {
        std::int32_t edge = -1;    ///< CAD edge
        double parameter[2] = {};  ///< at the two vertices that were asked for, in their order
    };
    explicit PathEdges(std::span<const EdgePath> paths);
    /// @returns Side with edge -1 where the mesh edge lies on no CAD edge; the first where it lies on several
    Side find(std::int32_t a, std::int32_t b) const;
    /// Calls visit(CAD edge) for all: faces that are not sewn have each an edge of its own at one place.
    template <class Visit>
    void for_each(std::int32_t a, std::int32_t b, const Visit& visit) const {
        for (std::size_t i = first(a, b); i < entries_.size() && entries_[i].joins(a, b); ++i) visit(entries_[i].edge);
    }

  private:
    struct Entry {
        std::int32_t low, high, edge;
        double at_low, at_high;
        bool joins(std::int32_t a, std::int32_t b) const { return std::minmax(a, b) == std::minmax(low, high); }
    };
    /// The first entry that is not before the mesh edge.
    std::size_t first(std::int32_t a, std::int32_t b) const;
    std::vector<Entry> entries_;
};

}  // namespace anisoquad::cad
