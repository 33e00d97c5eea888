#pragma once

#include <cstdint>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "parts/cuts.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct CleanupResult {
    std::int32_t operations = 0;
    std::int32_t irregular_before = 0;  ///< interior nodes with other than four edges
    std::int32_t irregular_after = 0;
};

/// Topological clean-up of the all-quad mesh: local patterns (cleanup/patterns.h, @cite canann1998topological,
/// @cite kinney1997cleanup, @cite anderson2009cleanup) are replaced by ones that are less irregular; then regions grow round
/// irregular nodes until they can be meshed with fewer (cleanup/region_growth.h, @cite verma2017regularization; the aim is that
/// of
/// @cite docampo2019regularization). A change is taken back where elements get too poor or too different in size, or where the
/// mesh leaves the surface. Anisotropic rows and constrained edges stay; of the nodes only interior ones move or vanish.
/// @pre all faces outside of rows that are to be improved are quads; others are left alone
CleanupResult clean_up(SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context = no_context());

/// The same for what was left near the cuts when the parts were cleaned up.
CleanupResult clean_up_near(const Cuts& cuts, SurfaceMesh& mesh, const ReferenceSurface& reference,
                            Context& context = no_context());

}  // namespace anisoquad
