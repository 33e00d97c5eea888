#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// The place of a surface that a ray meets first, and the mesh edge next to it.
struct EdgeHit {
    std::int32_t facet = -1;  ///< -1: the ray misses
    Point point = Point::Zero();
    std::int32_t from = -1;    ///< ends of the facet's edge nearest to the point, in the facet's direction
    std::int32_t to = -1;
    std::int32_t nearest = -1;  ///< the one of them that is nearer to the point
};

/// @param direction any length but zero; facets are hit from both sides; of equally far facets the lowest index wins
EdgeHit edge_on_ray(const PickSurface& surface, const Point& origin, const Eigen::Vector3d& direction);

}  // namespace anisoquad
