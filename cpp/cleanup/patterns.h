#pragma once

#include <vector>

#include "cleanup/region.h"
#include "cleanup/sectors.h"

/// The classical local patterns (@cite canann1998topological, @cite kinney1997cleanup, @cite anderson2009cleanup): each function
/// adds what can be done round one node; Trial decides.
namespace anisoquad {

struct Proposal {
    std::vector<Face> faces;
    Replacement replacement;
    int gain = 0;  ///< filled in by the caller
};

/// A node with two edges: its two quads become one.
void propose_doublet(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out);

/// The quads round v with one of them collapsed: v is merged into the opposite node of that quad.
void propose_face_collapse(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out);
/// The same for face(h) only, from(h) being merged.
void propose_collapse_of(const SurfaceMesh& mesh, HalfEdge h, std::vector<Proposal>& out);

/// The edges at v and opposite v in its quads: each is turned either way in the hexagon of its two quads.
void propose_edge_rotation(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out);

/// The hexagon of two quads at an edge of v, or of the three quads round v if it has three edges, with a node inside or without.
void propose_hexagon(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out);

/// Opens v along two of its edges: v becomes two nodes and a new quad lies between (the inverse of the collapse).
void propose_vertex_split(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out);

/// The quad, or it and a neighbour, once more inside of its outline, joined to it by a ring of quads: every corner gets one quad
/// more. A way out for a corner that lies flat on a line, where no quad alone can be better than degenerate.
void propose_inset(const SurfaceMesh& mesh, Face f, std::vector<Proposal>& out);

}  // namespace anisoquad
