#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// What is wrong with a patch's triangles as a base for quads.
struct PatchAssessment {
    std::int32_t triangles = 0;
    std::int32_t poor = 0;   ///< long and thin ones, or those that make no usable quad with any neighbour, if these are more
    bool is_poor = false;    ///< too many of them are so
    bool is_graded = false;  ///< their size changes too fast from one to the next
    bool is_coarse = false;  ///< they turn too far from one to the next, or quads across their edges leave the surface
};

/// Judges every patch's triangles: pairs of triangles longer than about 1:9 make no usable quad, nor do those of a fan, as the
/// ends of cylinders are in STL files, and where neighbours' sizes change faster than quads can follow, most nodes become
/// irregular (method 1b). Quads turn further still than the triangles that they are made of, and leave the surface where these
/// follow it just so.
/// @param curvature_angle degrees that neighbours may turn (Options::curvature_angle); 0: any
/// @param most_sagitta of quads of the triangles' size off the surface, in the mesh's lengths: beyond it a patch is coarse
/// @returns one entry per patch
std::vector<PatchAssessment> assess_patches(const SurfaceMesh& mesh, double curvature_angle, double most_sagitta);

}  // namespace anisoquad
