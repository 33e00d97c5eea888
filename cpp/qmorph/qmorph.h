#pragma once

#include <cstdint>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "parts/cuts.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// What the fill did.
struct QMorphResult {
    std::int32_t quads = 0;  ///< formed on front edges
    std::int32_t seams = 0;
    std::int32_t transitions = 0;  ///< transition seams and splits
    std::int32_t rungs = 0;        ///< edges from line to line cut in three
    std::int32_t closed_loops = 0;
    std::int32_t failed_edges = 0;  ///< front edges given up after repeated tries
    std::int32_t paired = 0;        ///< quads made by finish_remaining()
    std::int32_t walks = 0;
    std::int32_t left = 0;  ///< triangles that are left: 0 unless a patch has an odd boundary
};

/// Fills all triangles of the mixed mesh with quads, from the front inwards (paper 3.4; @cite owen1999qmorph). Components
/// without any front start from the quad of their best pair of triangles.
/// Edges of quads follow VertexInfo::size where it is known (qmorph/node_size.h).
/// @pre every component of triangles has an even number of front edges (features/parity.h)
/// @param reference surface to which smoothed nodes are brought back; null: they stay on the local fit (paper 2.1) only
/// @param cuts of the part that the mesh is: near them the front waits, and triangles are left for the fill of the whole
QMorphResult fill_with_quads(SurfaceMesh& mesh, const ReferenceSurface* reference = nullptr, Context& context = no_context(),
                             const Cuts& cuts = {});

}  // namespace anisoquad
