#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Moves a node towards the target on the surface fitted to its one-ring (on the tangent plane where there is no fit), and
/// back to the reference surface when one is given. A move is halved up to four times, then refused, when it inverts an
/// element, or leaves the worst element round the node both worse than it was and worse than `good_enough`. Where the worst
/// element is inverted already, a move that makes it less so passes. Steps below a hundredth of an edge's length are left out.
/// Corners, nodes on feature lines, boundary nodes and nodes of anisotropic rows are never moved.
/// @param hint facet of the reference surface near the node, kept up to date; may be null
/// @param good_enough scaled Jacobian; elements above it may get worse. 1: the worst element never gets worse
/// @returns true if the node was moved
bool move_node(SurfaceMesh& mesh, Vertex v, const Point& target, const ReferenceSurface* reference = nullptr,
               std::int32_t* hint = nullptr, double good_enough = 0.5);

/// True for the nodes that move_node() may move.
bool is_movable(const SurfaceMesh& mesh, Vertex v);

/// Unit sum of the area vectors of the faces round the node: in a flat neighbourhood the normal whatever the place of an
/// interior node, even where faces are inverted. Zero if undefined.
Eigen::Vector3d node_normal(const SurfaceMesh& mesh, Vertex v);

/// Worst element round the node, seen along `normal`: quads by their scaled Jacobian, negative if turned over; triangles by
/// three times their area over that of the equilateral triangle with the same sum of squared edge lengths, at most 1:
/// triangles don't last, so only poor ones count. −1…1
double worst_quality(const SurfaceMesh& mesh, Vertex v, const Eigen::Vector3d& normal);

}  // namespace anisoquad
