#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

struct ParityOptions {
    /// Source edges and edges beside quads belong to rows that are built or segmented: source edges are not split any more.
    bool sources_are_segmented = false;
};

struct ParityResult {
    std::int32_t odd = 0;            ///< components with an odd number of boundary edges that were met
    std::int32_t splits = 0;         ///< edges that were split
    std::vector<Vertex> new_nodes;   ///< their midpoints, in the order of the splits
    std::vector<std::int32_t> left;  ///< patches of components that no split can make even
};

/// Makes the number of boundary edges of every component of unmeshed triangles even, which filling it with quads needs
/// (paper 3.4, method 1).
///
/// A component is a set of triangles that are joined by unconstrained edges; its boundary edges are counted once for each of
/// its triangles beside them: constrained edges, and edges to a quad or to nothing. Which edges are split is a minimum T-join
/// on the graph whose nodes are the components and "outside" and whose links are the constrained edges that have a triangle on
/// each side, or a triangle and nothing; an edge costs less the longer it is compared with its neighbours on the line. Edges
/// are split at their middle, so lines keep their shape.
/// @returns what was split; `left` is empty unless a component has no way to "outside" or to another odd one
ParityResult make_parity_even(SurfaceMesh& mesh, const ParityOptions& options = {});

/// Number of components of unmeshed triangles with an odd number of boundary edges.
std::int32_t count_odd_components(const SurfaceMesh& mesh);

}  // namespace anisoquad
