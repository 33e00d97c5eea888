#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "input/triangle_soup.h"

namespace anisoquad {

/// Finds lines of the input again on the repaired surface: vertices were merged, edges halved, places cut apart.
class RepairedPaths {
  public:
    explicit RepairedPaths(const TriangleSoup& repaired);

    /// The path over the same places: merged vertices once, vertices on halved edges put in, and of vertices that were cut apart
    /// those that edges join. A closed path stays closed.
    /// @returns the path of merged vertices if there is none along edges; ids that do not exist are kept
    std::vector<std::int32_t> path(std::span<const std::int32_t> vertices) const;

    /// All edges at the place of each edge: both sides where the surface was cut there. An edge that is no more stays as it is.
    std::vector<std::array<std::int32_t, 2>> edges(std::span<const std::array<std::int32_t, 2>> pairs) const;

  private:
    bool exists(std::int32_t v) const { return v >= 0 && v < static_cast<std::int32_t>(soup_.points.size()); }
    bool joined(std::int32_t a, std::int32_t b) const;
    bool joined_somewhere(std::int32_t a, std::int32_t b) const;
    std::span<const std::int32_t> copies(std::int32_t v) const { return copies_[static_cast<std::size_t>(v)]; }
    void expand(std::int32_t a, std::int32_t b, int depth, std::vector<std::int32_t>& path) const;
    std::vector<std::int32_t> expanded(std::span<const std::int32_t> vertices) const;
    std::vector<std::int32_t> joined_copies(std::span<const std::int32_t> path, std::int32_t start, bool closed) const;

    const TriangleSoup& soup_;
    std::vector<std::pair<std::int32_t, std::int32_t>> edges_;              ///< sorted
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middle_;  ///< of halved edges
    std::vector<std::vector<std::int32_t>> copies_;  ///< per vertex: itself, and those that were cut off it
};

}  // namespace anisoquad
