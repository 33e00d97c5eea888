#pragma once

#include "mesh/area_vector.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Direction that the surface round a quad faces, of any length: the sum over the quads round its nodes, as far as no
/// constrained edge is between. Tells a quad that is turned over from one whose middle lies closer to the other side of a thin
/// body. @pre the faces round its nodes are quads
Eigen::Vector3d facing(const SurfaceMesh& mesh, Face quad);

/// The same, of the quads from h counter-clockwise round from(h) to the next edge that `is_end` names, or once round.
template <class IsEnd>
Eigen::Vector3d facing(const SurfaceMesh& mesh, HalfEdge h, IsEnd is_end) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    HalfEdge k = h;
    do {
        sum += doubled_area_vector_of_quad(mesh, mesh.face(k));
        k = mesh.rotated_ccw(k);
    } while (k != h && !is_end(SurfaceMesh::edge(k)));
    return sum;
}

}  // namespace anisoquad
