#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Numbers the components of faces that constrained edges separate, in the order of their lowest face index, and sets
/// FaceInfo::patch. Both sides of a line that ends inside a patch are the same patch.
/// @returns the number of patches
std::int32_t find_patches(SurfaceMesh& mesh);

}  // namespace anisoquad
