#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Closes a front loop of four edges with one quad, of six edges with two or three quads (the best template by the smallest
/// scaled Jacobian).
/// @param h an edge of the loop; @param length number of its edges
/// @param spirals the front goes round and round in the loop: four edges are closed even with a folded quad where smoothing
///        can open it, with free nodes and on flat ground; what would follow is a spiral of ever smaller quads
/// @returns false, and nothing changed, if the loop does not bound a disk of triangles or every template would be folded
bool close_small_loop(SurfaceMesh& mesh, HalfEdge h, int length, bool spirals = false);

struct FinishResult {
    std::int32_t pairs = 0;  ///< quads made of two neighbouring triangles
    std::int32_t walks = 0;  ///< pairs of single triangles that were brought together through the quads between them
    std::int32_t left = 0;   ///< triangles without a partner
};

/// The end of the fill where the front can not advance any more: neighbouring triangles are paired, best pairs first; single
/// triangles then walk through the quads between them (a triangle and its neighbour quad are one pentagon, cut anew with the
/// triangle on the far side) until two meet and make a quad. Rows and constrained lines are not crossed. Every patch with an
/// even boundary ends without a triangle.
FinishResult finish_remaining(SurfaceMesh& mesh);

}  // namespace anisoquad
