#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace anisoquad {

/// Sets of the numbers 0 … n − 1 that are united two by two; each is known by its lowest number.
class DisjointSets {
  public:
    explicit DisjointSets(std::int32_t n) : parent_(static_cast<std::size_t>(n)) { std::iota(parent_.begin(), parent_.end(), 0); }

    std::int32_t find(std::int32_t i) {
        while (parent(i) != i) i = parent(i) = parent(parent(i));
        return i;
    }

    /// @returns false if the two were in one set before
    bool unite(std::int32_t a, std::int32_t b) {
        a = find(a);
        b = find(b);
        parent(std::max(a, b)) = std::min(a, b);
        return a != b;
    }

  private:
    std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }

    std::vector<std::int32_t> parent_;
};

}  // namespace anisoquad
