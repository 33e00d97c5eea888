#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

/// Local changes of the connectivity that keep the mesh a valid half-edge mesh of the same topology. Faces may have any
/// number of edges in between; attributes follow: parts of a split edge or face inherit its info, and of two edges that
/// become one, the one that lies on a feature line wins.
namespace anisoquad {

/// True if the edge has a triangle on both sides, is not constrained, and its other diagonal does not exist yet.
bool is_flip_ok(const SurfaceMesh& mesh, Edge e);
/// Replaces the edge between two triangles by the other diagonal; the edge keeps its handle. @pre is_flip_ok
void flip(SurfaceMesh& mesh, Edge e);

/// Puts a node on the edge; the faces beside it get one edge more. halfedge(e, 0) then ends at the new node.
Vertex insert_vertex(SurfaceMesh& mesh, Edge e, const Point& p);
/// Puts a node on the edge and joins it to the opposite nodes of the triangles beside it.
/// @pre the faces beside the edge are triangles (or there is none)
Vertex split_edge(SurfaceMesh& mesh, Edge e, const Point& p);
/// Joins a new node inside the face to all its nodes.
Vertex split_face(SurfaceMesh& mesh, Face f, const Point& p);

/// Splits the face of h and g by an edge from(h) – from(g). @returns the half-edge from(h) → from(g); its face is the new one
/// @pre face(h) == face(g), h and g differ and are not neighbours' both ends
HalfEdge insert_edge(SurfaceMesh& mesh, HalfEdge h, HalfEdge g);
/// Merges the two faces beside the edge into the face of halfedge(e, 0). @pre both faces exist and differ
Face dissolve_edge(SurfaceMesh& mesh, Edge e);
/// Removes a node with two edges, which become one edge. @returns the remaining half-edge, in the face of h
/// @param h half-edge that ends at the node
HalfEdge dissolve_vertex(SurfaceMesh& mesh, HalfEdge h);

/// Link condition: collapsing from(h) into to(h) keeps the mesh manifold and of the same topology.
bool is_collapse_ok(const SurfaceMesh& mesh, HalfEdge h);
/// Merges from(h) into to(h), which keeps its place and its edges' handles; triangles beside h vanish. @pre is_collapse_ok
void collapse(SurfaceMesh& mesh, HalfEdge h);

/// The triangles inside a closed loop of half-edges (region on their left).
/// @param faces receives them; @param limit most faces to collect
/// @returns false if the region is larger, is not a disk, touches itself, holds a face that is not a triangle, or a constrained
/// edge
bool collect_region(const SurfaceMesh& mesh, std::span<const HalfEdge> loop, std::vector<Face>& faces, std::size_t limit = 4096);
/// Replaces the faces inside the loop by one face whose half-edges are the loop; what lay inside is removed, nodes too.
/// @pre collect_region(mesh, loop, faces)
Face replace_region(SurfaceMesh& mesh, std::span<const HalfEdge> loop, std::span<const Face> faces);

}  // namespace anisoquad
