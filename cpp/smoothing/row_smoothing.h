#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct RowSmoothingResult {
    int sweeps = 0;
    int moved = 0;  ///< moves that were kept
};

/// Smoothing for anisotropic quads (the future work of @cite merhof2007). Nodes of the rows slide along their row to where the
/// edges to the nodes below and above stand at right angles to it. A slide along the row keeps the rows' heights, and with them
/// the aspect ratios; a smoother that evens edge lengths would undo both. Nodes of sources, feature lines and the boundary stay.
/// A slide that makes a poor element round the node poorer is shortened, then refused.
/// @param reference surface to which nodes are brought back; null: they stay on the fitted one-ring
RowSmoothingResult smooth_rows(SurfaceMesh& mesh, const ReferenceSurface* reference, int sweeps = 5);

/// Slides one node of a row along it to where the worst element round it is best, at most a tenth of the way to its neighbours
/// in the row and without bending its column by more than 20°: for poor elements on top of the rows. @param hint as in
/// move_node() @returns true if the node was moved
bool slide_in_row(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference, std::int32_t* hint = nullptr);

}  // namespace anisoquad
