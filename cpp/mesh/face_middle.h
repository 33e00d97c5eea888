#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Mean of the nodes of a face.
inline Point face_middle(const SurfaceMesh& mesh, Face f) {
    Point sum = Point::Zero();
    int nodes = 0;
    for (const HalfEdge h : mesh.halfedges(f)) {
        sum += mesh.position(mesh.from(h));
        ++nodes;
    }
    return sum / nodes;
}

}  // namespace anisoquad
