#pragma once

#include "context.h"
#include "surface/facet_tree.h"

namespace anisoquad {

/// Largest distance of some triangles from a surface, in the units of the points: taken at their nodes, the middles of their
/// edges and their centres. The larger of both directions is the (sampled) Hausdorff distance. @throws Error{cancelled}
double distance_to(const FacetTree& surface, const FacetTree& triangles, const Context& context = no_context());

}  // namespace anisoquad
