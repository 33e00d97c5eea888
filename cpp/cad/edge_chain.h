#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cad/edge_paths.h"
#include "cad/shape.h"

namespace anisoquad::cad {

/// An edge of a chain, run from the low to the high end of its parameter or the other way.
struct DirectedEdge {
    std::int32_t edge = -1;
    bool reversed = false;
};

/// The edges that go on tangentially from an edge on either side, in order, in the direction of the edge; where several do, the
/// straightest. Ends where none does, at an edge that is in the chain already, or where the chain has come round.
/// @param angle degrees by which neighbours may turn at the most
std::vector<DirectedEdge> tangent_chain(const CadShape& shape, std::int32_t edge, double angle);

/// The mesh vertices along CAD edges that follow each other, given in any order; closed when the first is also the last. The
/// path runs in the direction of the first given edge, or against it.
/// @throws Error{invalid_source} with the CAD edges where they are not one line, or the mesh does not follow them
std::vector<std::int32_t> path_on_edges(const CadShape& shape, std::span<const EdgePath> paths,
                                        std::span<const std::int32_t> edges, bool reversed = false);

}  // namespace anisoquad::cad
