#pragma once

#include "anisotropy/local_size.h"
#include "anisotropy/row_stack.h"

namespace anisoquad {

/// Leads from the long edges on top of the rows to the local size of the triangles, where the paper has a sudden change (3.2, Fig. 5):
/// further rows of ordinary quads are built in which pairs of columns become four, by a template of six quads, until the front's
/// edges are no longer than a multiple of the local size or no row fits any more.
///
///     T0   T1   T2   T3   T4        M1 is joined to P0, T1, C and M3 to P2, T3, C;
///     |  \ M1 - C - M3 /  |         C lies on the side edge between the two columns.
///     P0 ------ P1 ------ P2
///
/// The quads belong to no row. @returns number of refining rows
int refine_to_local_size(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference);

}  // namespace anisoquad
