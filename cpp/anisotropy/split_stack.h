#pragma once

#include <vector>

#include "anisotropy/row_stack.h"

namespace anisoquad {

/// Cuts a stack where columns did not fit into the row that was tried last, so that the row can be built beside them. Each part
/// has the rows built so far over its own columns; the nodes where it is cut belong to both parts. What stays behind is made a
/// few row heights wide: a slot between rows that go on could not be filled well.
/// @param least columns that a part needs to go on (is_running); shorter ones stay with what did not fit beside them
/// @returns the parts along the stack; none, where no part can go on or nothing is known about single columns
std::vector<RowStack> split_stack(const SurfaceMesh& mesh, const RowStack& stack, std::size_t least);

/// Puts parts that were cut off each other and have equally many rows together again.
std::vector<RowStack> join_stacks(std::vector<RowStack> stacks);

}  // namespace anisoquad
