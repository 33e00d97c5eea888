#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// For each node the facet of the reference surface at which it was last, where the search for its next place starts; for a new
/// node that of the node moved last.
class FacetHints {
  public:
    /// −1 = none. Valid until the next call.
    std::int32_t& of(Vertex v, std::int32_t vertex_slots) {
        const auto i = static_cast<std::size_t>(v.index());
        if (facet_.size() <= i) facet_.resize(static_cast<std::size_t>(vertex_slots), -1);
        if (facet_[i] < 0) facet_[i] = last_;
        return facet_[i];
    }
    void set_last(std::int32_t facet) { last_ = facet; }

  private:
    std::vector<std::int32_t> facet_;
    std::int32_t last_ = -1;
};

}  // namespace anisoquad
