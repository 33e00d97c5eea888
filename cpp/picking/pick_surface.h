#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "features/feature_lines.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

/// What lines are picked on: the input triangulation with its feature lines, and how sharply it turns over each edge.
struct PickSurface {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    SurfaceMesh mesh;                ///< vertex i is point i, face i is triangle i
    std::vector<FeatureLine> lines;  ///< EdgeInfo::line is an index into them
    std::vector<double>
        curvature;  ///< per edge: turn of the facets over their width across it; positive where convex, 0 at the boundary
    double mean_curvature = 0.0;  ///< of |curvature|, weighted by the edges' lengths, and never below a tenth over the diagonal
    double diagonal = 0.0;        ///< of the bounding box
};

/// @param feature_angle, feature_edges as in Options
/// @throws Error for what check_input, check_options and find_features reject
PickSurface make_pick_surface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                              double feature_angle, std::span<const std::array<std::int32_t, 2>> feature_edges = {});

}  // namespace anisoquad
