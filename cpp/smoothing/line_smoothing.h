#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Slides a node of a feature line or boundary along it to where the worst element round it is best. Only where the line is
/// straight (the node and its two neighbours on it are in line to within 1e-6 of their distance), so that the shape is kept
/// exactly; the node stays between its neighbours. Corners and nodes of anisotropic rows stay.
/// @returns true if the node was moved
bool slide_on_line(SurfaceMesh& mesh, Vertex v);

}  // namespace anisoquad
