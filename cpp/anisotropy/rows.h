#pragma once

#include "anisotropy/local_size.h"
#include "anisotropy/row_stack.h"

namespace anisoquad {

/// What limits one more row.
struct RowLimits {
    int pass = 1;  ///< 1-based, written to the quads
    double longest_height =
        2.0;  ///< most height over the length of a front edge: beyond it the columns are too slim for the local size
    double clearance = 1.9;        ///< free way ahead that a row needs, in heights
    double free_share = 0.3;       ///< share of the way from the source to what lies ahead that stays free of rows
    double height_of_width = 0.0;  ///< least wanted height over the length of the front's edges, as far as the growth allows
    double growth = 1.2;           ///< most height over that of the row below
    double over_ends = 1.25;       ///< most height over that of the end columns on lines, or the rows tilt
};

/// Builds one structured row of quads on the top of the stack, one quad per front edge: no seam, no wedge (paper 3.2).
///
/// New nodes lie on straightest lines over the triangles that halve the front's sectors, at the height of the local size (its
/// growth over the row below limited, evened out along the row). At the ends the column runs along the
/// line there, taking its nodes, or, inside the surface, at right angles to the source. The new nodes are put into the triangles,
/// the row's edges recovered by swaps, and all quads are formed together.
/// @returns true if the row was built; otherwise no quad was made and stack.stopped says why
bool build_row(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference,
               const RowLimits& limits);

}  // namespace anisoquad
