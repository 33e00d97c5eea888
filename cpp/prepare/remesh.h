#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

struct RemeshResult {
    std::int32_t splits = 0;
    std::int32_t collapses = 0;
    std::int32_t flips = 0;
    std::int32_t moves = 0;
};

/// Adaptive remeshing of the unmeshed triangles towards VertexInfo::size (@cite botsch2004remeshing, @cite dunyach2013adaptive):
/// collapse short edges, split long ones, swap towards Delaunay, relax tangentially on the reference surface. Constrained
/// lines, front edges and quads are not touched.
/// @param zone per vertex slot, nonzero where the triangles may be changed; nodes that come up inside belong to it
RemeshResult remesh_triangles(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference, int iterations = 5);

/// Swaps edges between unmeshed triangles of the zone towards Delaunay (the two opposite angles sum to less than π).
std::int32_t swap_towards_delaunay(SurfaceMesh& mesh, const std::vector<char>& zone);

}  // namespace anisoquad
