#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// At which end of a front edge a side edge is wanted.
enum class End { left, right };

/// The side edge of the quad on front edge `h` at one of its ends (Owen 1999): the neighbouring front edge where the front turns
/// sharply; else the triangle edge closest to the wanted direction if within π/6; else a swapped edge; else a split one.
/// The wanted direction halves the sector of up to 5π/4, and cuts a wider one into sectors of about π/2.
/// A side edge that would close the front into a loop of odd length is split instead, so that it ends inside.
/// @param avoid a node at which the side edge must not end (the other side edge's end), or invalid
/// @returns half-edge from the front's node to the side edge's end; invalid if there is none
HalfEdge choose_side_edge(SurfaceMesh& mesh, HalfEdge h, End end, Vertex avoid);

/// Sector angle (radians) below which the neighbouring front edge is the side edge: 3π/4 (Owen's state bit).
inline constexpr double kSideAngle = 2.356194490192345;

}  // namespace anisoquad
