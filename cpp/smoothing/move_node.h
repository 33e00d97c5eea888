#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Moves a node towards the target on the surface fitted to its one-ring (on the tangent plane where there is no fit), and
/// back to the reference surface when one is given. A move that inverts an element, or makes the worst element round the node
/// worse, is halved up to four times, then refused. Where the worst element is inverted, a move that makes it less so passes.
/// Corners, nodes on feature lines, boundary nodes and nodes of anisotropic rows are never moved.
/// @param hint facet of the reference surface near the node, kept up to date; may be null
/// @returns true if the node was moved
bool move_node(SurfaceMesh& mesh,
               Vertex v,
               const Point& target,
               const ReferenceSurface* reference = nullptr,
               std::int32_t* hint = nullptr);

/// True for the nodes that move_node() may move.
bool is_movable(const SurfaceMesh& mesh, Vertex v);

/// Mean unit normal of the faces round the node, weighted by their angles there; zero if undefined.
Eigen::Vector3d node_normal(const SurfaceMesh& mesh, Vertex v);

/// Worst element round the node, seen along `normal`: quads by their smallest corner (scaled Jacobian), triangles by their
/// area over that of the equilateral triangle of the same edge lengths, −1…1; negative = inverted.
double worst_quality(const SurfaceMesh& mesh, Vertex v, const Eigen::Vector3d& normal);

}  // namespace anisoquad
