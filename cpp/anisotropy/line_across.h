#pragma once

#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct ThinnedLine {
    int merged = 0;  ///< nodes that were taken away
    int failed = 0;  ///< nodes that could not be: triangles behind them, smaller than the new edges, would turn over
};

/// Where a strip beside a merged source is too thin for rows (the blunt edge of a blade), the line on its other side is thinned
/// out as the source was: from the node across each node of the source to the next such node one edge is left, so that the strip
/// can be filled with one quad for each edge of the source. On both sides of that line triangles are collapsed along it.
/// @param nodes of the source, the strip's triangles on their left
/// @param sagitta how far the line's nodes that vanish may lie off its new edges
/// @param length per vertex, receives that of the edges for the nodes at their ends
ThinnedLine thin_line_across(SurfaceMesh& mesh, std::span<const Vertex> nodes, double sagitta, std::vector<double>& length);

/// The same on both sides of all sources, whatever lies across; where triangles behind a line are in the way, in turn with these.
/// @param sources nodes of each
/// @throws Error{cancelled}
void thin_lines_across(SurfaceMesh& mesh, std::vector<std::vector<Vertex>> sources, double sagitta,
                       const ReferenceSurface& reference, const Context& context = no_context());

}  // namespace anisoquad
