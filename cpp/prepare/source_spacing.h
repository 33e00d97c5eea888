#pragma once

#include <span>

#include "features/feature_lines.h"
#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "prepare/line_nodes.h"

namespace anisoquad {

struct SourceSpacingOptions {
    double longest = 0.02;    ///< the edges that are wanted where no line asks for less, in mesh units
    double shortest = 3e-4;   ///< in mesh units
    double deviation = 5e-5;  ///< of line edges from the input's line, in mesh units
};

/// Edges of a source, in mesh units, whose columns of quads are about as wide as their first row is high (paper 3.2, "isotropic
/// quadrilaterals"). At the source's ends the columns take the nodes of the lines that meet it there, and however curved such a
/// line is, its edges must not leave it: the row is not higher than the longest edge that starts there and stays within the
/// deviation.
/// @param chains all lines with their nodes of the moment; @param lines what they belong to; @param reference their places
/// @returns the shortest over all ends, options.longest where no line asks for less
double source_spacing(const SurfaceMesh& mesh, std::span<const LineNodes> chains, std::span<const FeatureLine> lines,
                      const ReferenceLines& reference, std::int32_t source, const SourceSpacingOptions& options);

}  // namespace anisoquad
