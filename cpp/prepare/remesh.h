#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "prepare/coverage.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// Edge of the equilateral triangles whose pairs are as large as squares of the wanted size, over that size.
inline constexpr double kTriangleEdge = 1.0745699;

struct RemeshResult {
    std::int32_t splits = 0;
    std::int32_t collapses = 0;
    std::int32_t flips = 0;
    std::int32_t moves = 0;
};

struct RemeshOptions {
    int sweeps = 5;
    double deviation = 4e-4;             ///< of triangles from the surface, over its diagonal
    std::span<const char> patches = {};  ///< per patch, nonzero where the triangles may be changed; empty: in all patches
    Coverage* coverage = nullptr;        ///< also guards the input against being left uncovered
    std::int32_t most_triangles = std::numeric_limits<std::int32_t>::max();  ///< of the mesh: no edge is split beyond them
    const Context* context = nullptr;                                        ///< asked now and then whether to go on
};

/// Adaptive remeshing of the unmeshed triangles towards VertexInfo::size (@cite botsch2004remeshing, @cite dunyach2013adaptive):
/// collapse short edges, split long ones, swap towards Delaunay, relax tangentially on the reference surface. Constrained
/// lines, front edges and quads are not touched; what would leave the surface by more than the deviation is not done.
/// @param zone per vertex slot, nonzero where the triangles may be changed; nodes that come up inside belong to it
RemeshResult remesh_triangles(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference,
                              const RemeshOptions& options = {});

/// Swaps edges between unmeshed triangles of the zone towards Delaunay (the two opposite angles sum to less than π).
std::int32_t swap_towards_delaunay(SurfaceMesh& mesh, const std::vector<char>& zone, const ReferenceSurface& reference,
                                   const RemeshOptions& options = {});

}  // namespace anisoquad
