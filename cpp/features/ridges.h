#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Lines along which a smooth surface folds over more sharply than its elements can follow: thin leading edges, rounded tips.
struct Ridges {
    std::vector<std::array<std::int32_t, 2>> edges;  ///< as pairs of vertices, like Options::feature_edges
    std::vector<char> in_fold;                       ///< per edge slot: the edge lies in the fold that a ridge stands for
};

struct RidgeOptions {
    double width = 0.0;   ///< of a fold at the most, in mesh units
    double angle = 50.0;  ///< degrees by which a fold turns at the least
};

/// Finds ridges among the edges of some patches. The turn of an edge is the angle between the facets at half the width on either
/// side of it, reached on straightest lines across it. Where it is large, chains of edges are grown along the middle of the
/// fold, where either side turns by as much, until the fold ends or they meet another line; one that would meet it at less than
/// 30° ends an edge before, or no quad fits between the two. None lies within the width of a source.
/// @param patches per patch, nonzero where to look
Ridges find_ridges(const SurfaceMesh& mesh, std::span<const char> patches, const RidgeOptions& options);

}  // namespace anisoquad
