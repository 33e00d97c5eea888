#pragma once

#include <span>

#include "mesh/surface_mesh.h"
#include "options.h"

namespace anisoquad {

/// Length over the model's diagonal below which an edge may be a needle's: half of the distance at which lines count as
/// followed.
inline constexpr double kNeedleLength = 5e-5;

/// Collapses the short edge of needles, triangles with two long edges and one of a hair's length, the shortest first. No quad
/// of the mesh's size can stand on such an edge, which comes from curves that miss each other by a hair. No point of the surface
/// moves by more than the needle's length; two lines do not become one, so that strips between two feature lines (a blunt
/// trailing edge) stay as they are. Vertices of sources and of Options::feature_edges stay.
/// @param mesh triangles fresh from from_arrays(); vertices keep their handles
/// @param diagonal of the model
/// @returns the number of edges that were collapsed
int collapse_needles(SurfaceMesh& mesh, double diagonal, std::span<const Source> sources, const Options& options);

}  // namespace anisoquad
