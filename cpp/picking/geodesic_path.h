#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// A place where a line crosses an edge of the mesh: from(halfedge) + t · (to − from), 0 < t < 1.
struct Crossing {
    Edge edge;
    double t = 0.5;  ///< from from(halfedge(edge, 0))
};

/// One straight piece of a line over the surface, from vertex to vertex.
struct GeodesicPiece {
    Vertex from;
    Vertex to;
    std::vector<Crossing> crossings;  ///< in order; empty: the piece is a mesh edge
};

/// Shortens a path of mesh edges, without moving its ends, until it is straight: a geodesic of the same homotopy class, by
/// flips of an intrinsic triangulation (FlipOut) @cite sharp2020, then traced over the triangles.
/// @param path neighbours joined by mesh edges; no vertex twice
/// @pre all faces are triangles
/// @returns the pieces in order; nothing when the trace loses its way in degenerate triangles
std::optional<std::vector<GeodesicPiece>> geodesic_path(const SurfaceMesh& mesh, std::span<const Vertex> path);

}  // namespace anisoquad
