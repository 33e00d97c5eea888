#pragma once

#include <cstdint>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct CleanupResult {
    std::int32_t operations = 0;
    std::int32_t irregular_before = 0;  ///< interior nodes with other than four edges
    std::int32_t irregular_after = 0;
};

/// Topological clean-up of the all-quad mesh (@cite canann1998topological, @cite kinney1997cleanup): local patterns are replaced
/// by ones with fewer irregular nodes, where no element gets worse than a bound. Anisotropic rows and constrained lines stay.
CleanupResult clean_up(SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context = no_context());

}  // namespace anisoquad
