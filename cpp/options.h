#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace anisoquad {

/// One pass of the Three-Step-Method (paper 3.2, 3.3).
struct Pass {
    int ratio = 2;  ///< quads merged into one along the source (the pass's anisotropy)
    int rows = 0;   ///< anisotropic rows kept by this pass; 0: as many as the local size allows
};

/// On which side of a source, seen along its direction with the surface normal up, rows are built.
enum class Sides { both, left, right };

/// A line source of anisotropy (paper 3.1).
struct Source {
    std::vector<std::int32_t> vertices;  ///< input vertex ids; neighbours share a mesh edge; closed when first == last
    std::vector<Pass> passes;            ///< first pass first; empty: no merge, one pass of rows is not built
    Sides sides = Sides::both;
};

/// The passes of the paper for a maximum anisotropy: up to 1:5 one pass, then products whose last pass is 2
/// (6 = 3·2, 8 = 4·2, 16 = 4·2·2). @throws Error{invalid_option} if anisotropy < 1
std::vector<Pass> passes_for_anisotropy(int anisotropy);

/// Everything a user can set, with the only place where the defaults stand.
struct Options {
    double feature_angle = 40.0;                             ///< degrees; edges whose facets turn by more are feature lines
    std::vector<std::array<std::int32_t, 2>> feature_edges;  ///< further feature edges, as pairs of input vertex ids
    bool repair = false;  ///< mend bad input (see input/repair.h) instead of rejecting it; the report says what was changed
    bool prepare = true;  ///< remesh patches whose triangles can't hold quads first: too long and thin, or too steeply graded
    double size = 0.0;    ///< wanted edge length of the quads in the input's unit; remeshes all patches. 0: that of the triangles
    std::vector<double> vertex_size;  ///< the same, one length per input vertex; empty: `size` everywhere
    double growth = 1.3;              ///< limit between the sizes of neighbouring elements where patches are remeshed
    double curvature_angle = 30.0;    ///< degrees that one edge may turn along the surface where patches are remeshed; 0: any
    double row_growth = 1.2;          ///< limit of the height of a row over that of the row before; the last few, which lead
                                      ///< over to isotropic quads where a pass has no given number of rows, may grow by 1.6
    int smoothing_passes = 30;        ///< limit of sweeps of the final smoothing
    bool cleanup = true;              ///< topological clean-up after the fill
    int threads = 0;        ///< most threads that a run uses; 0: as many as there are cores. The mesh is the same for any number
    bool validate = false;  ///< check the invariants of the mesh after every stage (always on in debug builds)
    bool record_stages = false;  ///< keep a copy of the mesh after every rows and merge step (the paper's Fig. 3, 6, 7)
};

}  // namespace anisoquad
