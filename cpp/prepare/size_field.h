#pragma once

#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// All lengths in the frame of the mesh.
struct SizeFieldOptions {
    double largest = 0.02;          ///< edge length of quads where nothing asks for less
    double smallest = 5e-3;         ///< what curvature and narrow places ask for at the most
    double curvature_angle = 30.0;  ///< degrees that one edge may turn along the surface; 0: the curvature is not looked at
    double sagitta = 1e-3;          ///< of an edge off the curved surface
    double growth = 1.3;            ///< limit between the sizes of neighbouring elements
    std::span<const double> vertex_size = {};  ///< per input vertex, instead of `largest`; empty: none
    std::span<const char> in_fold = {};        ///< per edge of the input's mesh: its turn is a ridge's, not a curvature
};

/// Wanted edge lengths of quads, for triangulations whose own edges say nothing about it (tessellations of CAD faces: long and
/// thin, coarse on planes) or where the user asks for a size. Per facet of the input: the angle by which neighbouring facets
/// turn over the height of the facet at their common edge gives the curvature across it (@cite dunyach2013adaptive), and facets
/// that span a narrow place between two lines give its width.
class SizeField {
  public:
    SizeField(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
              const ReferenceSurface& reference, const SizeFieldOptions& options);

    /// Bounds the size of one facet from above.
    void limit(std::int32_t facet, double size);
    /// Makes all sizes larger where squares of them would take more than so many triangles. @returns the factor, at least 1
    double coarsen_to(double triangles, std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> facets);

    /// Writes VertexInfo::size of all nodes of the mesh: the field at the node, then bounded growth along the mesh's edges.
    /// @param hint per vertex slot, facets near the nodes; kept up to date, may be empty at first
    /// @param kept per edge slot or empty: nonzero for edges of lines that stay as they are; nodes there get their length
    /// @param most per vertex slot or empty: bounds from above, 0 = none
    /// @throws Error{cancelled}
    void assign(SurfaceMesh& mesh, std::vector<std::int32_t>& hint, std::span<const char> kept, std::span<const double> most = {},
                const Context& context = no_context()) const;

  private:
    double size_at_ridge(double radius) const;
    void limit_by_curvature(const SurfaceMesh& mesh);
    void limit_by_width(const SurfaceMesh& mesh);
    double size_at(const SurfaceMesh& mesh, Vertex v, std::int32_t& hint) const;

    const ReferenceSurface& reference_;
    SizeFieldOptions options_;
    std::vector<double> facet_size_;
};

}  // namespace anisoquad
