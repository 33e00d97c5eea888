#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// A chain of constrained edges between two corners, or a closed one.
struct FeatureLine {
    std::vector<Vertex> nodes;  ///< in order; neighbours share an edge; first == last when closed
    bool closed = false;        ///< the line ends where it begins (that node is a corner only if the line is not smooth there)
    bool is_source = false;     ///< part of a source of anisotropy; runs in the source's direction
    bool is_ridge = false;      ///< the middle of a fold that elements could not follow (features/ridges.h)
    bool is_boundary = false;   ///< edges of the surface's boundary
    std::int32_t source = -1;   ///< index of the source, -1 = none
};

/// Finds the edges that the quads must cover: boundary, dihedral turns above Options::feature_angle, Options::feature_edges
/// and sources; joins them into lines and marks the mesh.
///
/// Corners are nodes where other than two constrained edges meet, where two different kinds of line (boundary, source, other
/// edge) follow each other, where the line turns by more than 45°, and the ends of open sources. Sets EdgeInfo::line and
/// EdgeInfo::source, VertexInfo::line and VertexInfo::kind; what they held before is forgotten.
/// @param mesh fresh from from_arrays(), so that vertex i is input vertex i
/// @pre check_sources and check_options have passed
/// @param ridges edges of ridges, as pairs of vertices
/// @throws Error{invalid_feature_edge}
/// @returns the lines; EdgeInfo::line is an index into them
std::vector<FeatureLine> find_features(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options,
                                       std::span<const std::array<std::int32_t, 2>> ridges = {});

}  // namespace anisoquad
