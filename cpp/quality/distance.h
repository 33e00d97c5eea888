#pragma once

#include "surface/facet_tree.h"

namespace anisoquad {

/// Largest distance of some triangles from a surface, in the units of the points: taken at their nodes, the middles of their edges and
/// their centres. The larger of both directions is the (sampled) Hausdorff distance.
double distance_to(const FacetTree& surface, const FacetTree& triangles);

}  // namespace anisoquad
