#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Blacker's smoothing of a node on the front @cite blacker1991paving (row smoothing), @cite owen1999qmorph (local smoothing):
/// the isoparametric mean; at a node with exactly two quads, side by side, corrected so that the edge between them has the
/// desired length (mean of the neighbouring edges) and halves the angle at its lower end.
/// @returns false at a node without quads
bool front_node_target(const SurfaceMesh& mesh, Vertex v, Point& target);

}  // namespace anisoquad
