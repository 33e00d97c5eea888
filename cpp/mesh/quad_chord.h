#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

/// A chord: the edges that follow each other as opposite sides of quads.
namespace anisoquad {

/// Where the chord ends that leaves the face of `h` across its edge.
/// @param h half-edge of a triangle, or of nothing
/// @param quads receives the number of quads on the way
/// @returns half-edge of the chord's last edge in the triangle that lies beyond, or in nothing
HalfEdge chord_end(const SurfaceMesh& mesh, HalfEdge h, int& quads);

/// Halves all edges of that chord and the quads between them, so that one more edge meets each of its ends. New nodes lie
/// in the middle of their edges; the triangles at the ends are cut in two.
/// @param nodes receives the new nodes, appended in order
void split_chord(SurfaceMesh& mesh, HalfEdge h, std::vector<Vertex>& nodes);

}  // namespace anisoquad
