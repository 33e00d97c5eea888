#pragma once

#include <span>
#include <vector>

#include "features/feature_lines.h"
#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "prepare/coverage.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// The nodes of one feature line in order, with their places on the input's line (see ReferenceLines).
struct LineNodes {
    std::int32_t line = -1;
    std::vector<Vertex> nodes;  ///< first == last when closed
    std::vector<double> ways;   ///< way along the input's line; 0 … its length
};

struct LineOptions {
    double deviation = 0.0;        ///< of line edges from the input's line, in mesh units
    double sagitta = 0.0;          ///< of triangles from the surface, in mesh units
    Coverage* coverage = nullptr;  ///< also guards the input against being left uncovered
    bool equal_parts = false;  ///< long edges are split into as many equal parts as fit their size; else halved, so that lines
                               ///< beside each other get the same nodes
};

/// @param lines with their nodes still at the input's places
std::vector<LineNodes> line_nodes(const SurfaceMesh& mesh, std::span<const FeatureLine> lines, const ReferenceLines& reference);

/// One sweep of redistribution of a line's nodes towards VertexInfo::size: short edges are collapsed, long ones split, and
/// nodes slid along the input's line until neighbouring edges fit their sizes alike. The ends of the line stay; edges stay
/// near the input's line; triangles beside the line are never turned over.
/// @param lines, surface the input's
/// @returns number of changes
std::int32_t redistribute_line_nodes(SurfaceMesh& mesh, LineNodes& line, const ReferenceLines& lines,
                                     const ReferenceSurface& surface, const LineOptions& options);

}  // namespace anisoquad
