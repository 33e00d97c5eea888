#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Where a straightest line over the unmeshed triangles ends.
struct TraceEnd {
    Face face;  ///< triangle in which the line ends
    Point position = Point::Zero();
    double length = 0.0;     ///< way made
    double incidence = 0.0;  ///< sine of the angle between the line and the edge that blocks it
    bool blocked = false;    ///< it met a front or constrained edge, the end of the surface, before its length was used up
};

/// Follows the straightest line that leaves a front node into the sector before it, unfolding triangle after triangle.
/// @param in front edge that ends at the node; @param angle radians from the reverse of `in`, inside the sector
/// @param length way to go, in mesh units
TraceEnd trace_geodesic(const SurfaceMesh& mesh, HalfEdge in, double angle, double length);

}  // namespace anisoquad
