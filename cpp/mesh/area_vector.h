#pragma once

#include <Eigen/Geometry>
#include <span>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Twice the area vector of a triangle.
inline Eigen::Vector3d doubled_area_vector(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a); }
/// @pre the face is a triangle
inline Eigen::Vector3d doubled_area_vector(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    return doubled_area_vector(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.to(mesh.next(h))));
}

/// Twice the area vector of a quad: the cross product of its diagonals. @pre the face is a quad
inline Eigen::Vector3d doubled_area_vector_of_quad(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    const HalfEdge opposite = mesh.next(mesh.next(h));
    return (mesh.position(mesh.from(opposite)) - mesh.position(mesh.from(h)))
        .cross(mesh.position(mesh.to(opposite)) - mesh.position(mesh.to(h)));
}

/// Sum over a region of triangles: the direction that the region faces as a whole.
inline Eigen::Vector3d doubled_area_vector(const SurfaceMesh& mesh, std::span<const Face> faces) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Face f : faces) sum += doubled_area_vector(mesh, f);
    return sum;
}

}  // namespace anisoquad
