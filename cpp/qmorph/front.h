#pragma once

#include "mesh/surface_mesh.h"
#include "parts/cuts.h"

/// The front (Owen 1999): directed edges with an unmeshed triangle on their left and, on their right, a finished quad, nothing,
/// or a constrained line. It is not stored but read off the mixed mesh, so it is at every moment a set of closed loops.
namespace anisoquad {

/// True if `h` is a front edge.
inline bool is_front(const SurfaceMesh& mesh, HalfEdge h) {
    const Face f = mesh.face(h);
    if (!f.is_valid() || !mesh.is_triangle(f)) return false;
    const Face other = mesh.face(SurfaceMesh::twin(h));
    return !other.is_valid() || mesh.info(SurfaceMesh::edge(h)).line >= 0 || !mesh.is_triangle(other);
}

/// True for a face with a front edge.
inline bool touches_front(const SurfaceMesh& mesh, Face f) {
    for (const HalfEdge h : mesh.halfedges(f)) {
        if (is_front(mesh, h)) return true;
    }
    return false;
}

/// True for edges so near to a cut that what is made of them might reach it, or might be made otherwise without it.
bool is_near_cut(const SurfaceMesh& mesh, HalfEdge h, const Cuts& cuts);

/// Front edge that follows `h` in its loop. @pre is_front(mesh, h)
HalfEdge next_front(const SurfaceMesh& mesh, HalfEdge h);
/// Front edge before `h` in its loop. @pre is_front(mesh, h)
HalfEdge previous_front(const SurfaceMesh& mesh, HalfEdge h);

/// Angle (radians) of the unmeshed sector at to(h), between front edge `h` and the next one: the sum of the triangles' angles.
double front_angle(const SurfaceMesh& mesh, HalfEdge h);

/// front_angle(mesh, h) < limit, without the angles. @param limit radians, 0 … π
bool is_front_angle_below(const SurfaceMesh& mesh, HalfEdge h, double limit);

/// Area vector of the unmeshed triangles in the sector at to(h).
Eigen::Vector3d sector_normal(const SurfaceMesh& mesh, HalfEdge h);

/// Front edge that ends at from(spoke) and whose sector there holds the edge `spoke`; invalid if from(spoke) has no front edge
/// @param spoke an edge between unmeshed triangles
HalfEdge front_into(const SurfaceMesh& mesh, HalfEdge spoke);

struct FrontWay {
    int edges = 0;
    bool along_cut = false;  ///< where it goes on behind is not known
};

/// The front from `first` up to and with `last`; -1 edges if `last` is on another loop or further than `limit`.
FrontWay front_way(const SurfaceMesh& mesh, HalfEdge first, HalfEdge last, int limit);

/// Number of edges of the loop of `h`, or `limit` + 1 if there are more.
int loop_length(const SurfaceMesh& mesh, HalfEdge h, int limit);

}  // namespace anisoquad
