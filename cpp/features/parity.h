#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

struct ParityResult {
    std::int32_t odd = 0;            ///< components with an odd number of boundary edges that were met
    std::int32_t splits = 0;         ///< edges that were split, those of chords included
    std::vector<Vertex> new_nodes;   ///< their midpoints, in the order of the splits
    std::vector<std::int32_t> left;  ///< patches of components that no split can make even
};

/// Makes the number of boundary edges of every component of unmeshed triangles even, which filling it with quads needs
/// (paper 3.4, method 1).
///
/// A component is a set of triangles that are joined by unconstrained edges; its boundary edges are counted once for each of
/// its triangles beside them: constrained edges, and edges to a quad or to nothing. Which edges are split is a minimum T-join
/// on the graph whose nodes are the components and "outside" and whose links are the constrained edges that have a triangle on
/// each side, or a triangle and nothing, and the chords through rows of quads from one such side to another; an edge costs less
/// the longer it is compared with its neighbours on the line, sources and chords cost more. Edges are split at their middle, so
/// lines keep their shape.
/// @returns what was split; `left` is empty: on every closed surface the number of odd components is even
ParityResult make_parity_even(SurfaceMesh& mesh);

/// Number of components of unmeshed triangles with an odd number of boundary edges.
std::int32_t count_odd_components(const SurfaceMesh& mesh);

}  // namespace anisoquad
