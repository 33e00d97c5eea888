#pragma once

#include "context.h"
#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "options.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct FinalSmoothingResult {
    int sweeps = 0;
    int moves = 0;
    double min_before = 1.0;  ///< smallest scaled Jacobian
    double mean_before = 1.0;
    double min_after = 1.0;
    double mean_after = 1.0;
    int inverted = 0;  ///< elements that are still inverted
};

/// The final smoothing of the finished mesh: anisotropic rows by smooth_rows(); all other nodes by relax_shapes(), which is fast
/// where the mesh is uneven over many quads, then by guarded sweeps that raise the
/// mean scaled Jacobian, inverted and poor elements by optimise_node(), nodes of rows once the others have settled; until neither
/// the worst nor the mean gets better, at most Options::smoothing_passes sweeps. Only nodes round which something moved are
/// visited again. Nodes are brought back to their patch of the reference surface. Nodes on straight feature lines slide along
/// them (slide_on_line()); corners stay. Triangles that are left are tolerated.
FinalSmoothingResult smooth_mesh(SurfaceMesh& mesh, const ReferenceSurface& reference, const Options& options = {},
                                 Context& context = no_context(), const ReferenceLines& lines = {});

}  // namespace anisoquad
