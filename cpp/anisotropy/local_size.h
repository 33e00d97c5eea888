#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/reference_surface.h"

namespace anisoquad {

/// Edge length of the input triangles near a point, smoothed over neighbouring facets: the height that a row should have there.
class LocalSize {
  public:
    LocalSize(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
              const ReferenceSurface& reference);

    /// @param hint facet near p or -1, updated
    double operator()(const Point& p, std::int32_t& hint) const;

  private:
    const ReferenceSurface& reference_;
    std::vector<double> facet_size_;
};

}  // namespace anisoquad
