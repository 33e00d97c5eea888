#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// The mesh edge that a ray points at.
struct EdgeHit {
    std::int32_t facet = -1;      ///< that the ray meets first, from either side; -1: it misses them all
    Point point = Point::Zero();  ///< where it meets the facet, else where it passes the edge
    std::int32_t from = -1;       ///< ends of the edge; -1: there is none
    std::int32_t to = -1;
};

/// The edge that is meant by a ray: the nearest edge of a feature line within reach of the ray, that no facet hides; else the
/// nearest edge of the facet that the ray meets; else, beside the outline of the surface, the nearest edge within reach.
/// @param direction any length but zero; of equally near elements the one with the lowest index wins
/// @param reach distance from the ray, in the points' unit
EdgeHit edge_on_ray(const PickSurface& surface, const Point& origin, const Eigen::Vector3d& direction, double reach = 0.0);

}  // namespace anisoquad
