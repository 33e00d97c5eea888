#pragma once

#include "mesh/surface_mesh.h"
#include "parts/cuts.h"

namespace anisoquad {

/// Fills the sharp corners of the front between two constrained lines (a wing's cap at the trailing edge) or a line and a row,
/// which no seam can close, before the front starts: the corner C and its neighbours U and L on the lines make a quad with a new
/// node just beyond the middle of U – L. The strip that follows then has an even pair of columns; a front that came upon the
/// corner from the inside would have to pair the nodes of the two lines askew.
/// @param cuts corners near them are left
/// @returns number of corner quads
int fill_sharp_corners(SurfaceMesh& mesh, const Cuts& cuts = {});

}  // namespace anisoquad
