#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "features/feature_lines.h"
#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "options.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct PrepareResult {
    std::int32_t patches = 0;  ///< that were remeshed
    std::int32_t poor = 0;     ///< of them, those with triangles too long and thin for quads
    std::int32_t graded = 0;   ///< of them, those whose triangles' size changes too fast
    std::int32_t coarse = 0;   ///< of them, those whose triangles turn too far
    std::int32_t poor_triangles = 0;
    std::int32_t triangles_before = 0;
    std::int32_t triangles_after = 0;
    double size = 0.0;  ///< the largest wanted edge length
};

/// What prepare_triangles() works from.
struct PrepareInput {
    std::span<const Point> points;
    std::span<const std::array<std::int32_t, 3>> triangles;
    const ReferenceSurface& reference;
    std::span<const FeatureLine> lines;
    const ReferenceLines& reference_lines;
    double unit = 1.0;                   ///< the user's lengths over the mesh's
    std::span<const char> in_fold = {};  ///< see Ridges::in_fold
    bool has_target = false;  ///< the nodes go to a surface of their own: how far quads are off the triangles says nothing
};

/// Per patch: 1 where it is to be remeshed. @param mesh fresh from find_features() and find_patches(); @param diagonal of the
/// model
std::vector<char> patches_to_remesh(const SurfaceMesh& mesh, const Options& options, double diagonal);

/// Remeshes the patches whose triangles would not hold quads (see assess_patches()), or all where Options::size asks for a size:
/// towards a size field from the curvature, the wanted size and a bounded growth, with the nodes of lines redistributed along
/// them (method 1b). Good triangles are left untouched.
/// @param mesh fresh from find_features() and find_patches()
/// @param sources in and out: their vertices become those of the prepared mesh
PrepareResult prepare_triangles(SurfaceMesh& mesh, const PrepareInput& input, std::vector<Source>& sources,
                                const Options& options, Context& context = no_context());

}  // namespace anisoquad
