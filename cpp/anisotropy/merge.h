#pragma once

#include <vector>

#include "anisotropy/row_stack.h"

namespace anisoquad {

/// Merges the quads of each segment in each row of the stack (paper 3.2, step two), all rows from the source up (3.3).
/// @param kept per column end: true where a segment ends; columns between two kept ends become one
/// Nodes between segments vanish from all layers but the source (see merge_source_nodes) and the uppermost one, whose row then
/// has faces of more than four edges: it is to be given back as triangles (anisotropy/transition.h).
void merge_rows(SurfaceMesh& mesh, RowStack& stack, const std::vector<char>& kept);

/// Takes the source's nodes between segments away, after the rows on both sides were merged. On a side without rows the
/// triangles there are collapsed along the source.
/// @returns number of nodes that could not be taken away
int merge_source_nodes(SurfaceMesh& mesh, const std::vector<Vertex>& nodes, const std::vector<char>& kept);

}  // namespace anisoquad
