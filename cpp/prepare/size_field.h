#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct SizeFieldOptions {
    double curvature_angle = 20.0;  ///< degrees that one edge may turn along the surface
    double growth = 0.35;           ///< of the size per unit of way
    double smallest = 3e-3;         ///< in a frame where the model's diagonal is 1
    double largest = 0.06;
};

/// Edge lengths that the surface's curvature allows, for triangulations whose own edges say nothing about it (tessellations of
/// CAD faces: long and thin, coarse on planes). Per facet of the input: the angle by which neighbouring facets turn over the
/// height of the facet at their common edge gives the curvature across it. @cite dunyach2013adaptive
class SizeField {
  public:
    SizeField(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles, const ReferenceSurface& reference,
              const SizeFieldOptions& options);

    /// Writes VertexInfo::size of all nodes of the mesh: the field at the node, then bounded growth along the mesh's edges.
    void assign(SurfaceMesh& mesh) const;

  private:
    const ReferenceSurface& reference_;
    SizeFieldOptions options_;
    std::vector<double> facet_size_;
};

}  // namespace anisoquad
