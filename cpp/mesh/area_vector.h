#pragma once

#include <Eigen/Geometry>
#include <span>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Twice the area vector of a triangle. @pre the face is a triangle
inline Eigen::Vector3d doubled_area_vector(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    const Point& p = mesh.position(mesh.from(h));
    return (mesh.position(mesh.to(h)) - p).cross(mesh.position(mesh.to(mesh.next(h))) - p);
}

/// Sum of it over a region of triangles: the direction that the region faces as a whole.
inline Eigen::Vector3d doubled_area_vector(const SurfaceMesh& mesh, std::span<const Face> faces) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Face f : faces) sum += doubled_area_vector(mesh, f);
    return sum;
}

}  // namespace anisoquad
