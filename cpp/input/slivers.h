#pragma once

#include <span>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// Height over the model's diagonal below which a triangle may be a sliver: half of the distance at which lines count as
/// followed.
inline constexpr double kSliverHeight = 5e-5;

/// Turns the longest edge of slivers, triangles whose one corner lies on the edge between the other two but for a hair, the
/// thinnest first. Their normals are those of rounding errors, so that features would run round each of them and leave patches
/// without width. The surface moves by their height, feature lines to the two other edges. Edges of the boundary, of
/// sources and of Options::feature_edges stay, and thin triangles with a short edge, which strips between two lines consist of.
/// @param mesh triangles fresh from from_arrays() @param diagonal of the model
/// @returns the faces that changed, each once, ascending; faces and vertices keep their handles
std::vector<Face> turn_slivers(SurfaceMesh& mesh, double diagonal, std::span<const Source> sources, const Options& options);

}  // namespace anisoquad
