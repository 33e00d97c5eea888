#pragma once

#include "anisotropy/row_stack.h"

namespace anisoquad {

/// Gives the uppermost row back as triangles (paper 3.2, step three): in every merged face a fan from the merged edge below to
/// the edges above, so that no node hangs. The row leaves the stack.
void give_back_top_row(SurfaceMesh& mesh, RowStack& stack);

}  // namespace anisoquad
