#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "options.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct PrepareResult {
    std::int32_t patches = 0;       ///< patches that were remeshed
    std::int32_t poor = 0;          ///< their triangles that could not hold quads
    std::int32_t triangles_before = 0;  ///< of the whole mesh
    std::int32_t triangles_after = 0;
};

/// Remeshes the patches whose triangles could not hold quads (tessellations of CAD faces: long and thin) towards a size field from the
/// curvature, with bounded growth (method 1b). Lines between patches are kept, their long edges split. Patches of good triangles
/// are left untouched, so that the paper's own case is the paper's own method.
/// @param points, triangles the input in the mesh's frame, in which the model's diagonal is 1
/// @param sources their vertex lists get the nodes that come up on them
PrepareResult prepare_triangles(SurfaceMesh& mesh, std::span<const Point> points,
                                std::span<const std::array<std::int32_t, 3>> triangles, const ReferenceSurface& reference,
                                std::vector<Source>& sources, Context& context = no_context());

}  // namespace anisoquad
