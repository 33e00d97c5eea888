#pragma once

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct RowSmoothingResult {
    int sweeps = 0;
    int moved = 0;  ///< moves that were kept
};

/// Smoothing for anisotropic quads (the future work of @cite merhof2007): the nodes of the rows move along and across their
/// row so that columns run smoothly and at right angles to the rows, while row heights, and with them aspect ratios, are kept.
/// Nodes of sources and feature lines stay.
/// @param reference surface to which nodes are brought back; may be null
RowSmoothingResult smooth_rows(SurfaceMesh& mesh, const ReferenceSurface* reference, int sweeps = 5);

}  // namespace anisoquad
