#pragma once

#include <cstdint>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

struct FaceComponents {
    std::vector<std::int32_t> of_face;  ///< per face slot; -1 for deleted faces and those that don't count
    std::vector<Face> first;            ///< per component: its lowest face

    std::int32_t count() const { return static_cast<std::int32_t>(first.size()); }
};

/// Numbers the components of faces in the order of their lowest face index.
/// @param counts callable, Face → bool: the others belong to none
/// @param joins callable, Edge → bool: whether an edge between two faces that count joins them
template <class Counts, class Joins>
FaceComponents face_components(const SurfaceMesh& mesh, const Counts& counts, const Joins& joins) {
    // Over the edges in their order, which is the memory's: a walk from face to face waits for each of them.
    DisjointSets sets(mesh.face_slots());
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        const Edge e(i);
        if (mesh.is_deleted(e) || mesh.is_boundary(e)) continue;
        const Face f = mesh.face(SurfaceMesh::halfedge(e, 0));
        const Face g = mesh.face(SurfaceMesh::halfedge(e, 1));
        if (counts(f) && counts(g) && joins(e)) sets.unite(f.index(), g.index());
    }
    FaceComponents result;
    result.of_face.assign(static_cast<std::size_t>(mesh.face_slots()), -1);
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i)) || !counts(Face(i))) continue;
        const std::int32_t lowest = sets.find(i);
        result.of_face[static_cast<std::size_t>(i)] =
            lowest == i ? result.count() : result.of_face[static_cast<std::size_t>(lowest)];
        if (lowest == i) result.first.emplace_back(i);
    }
    return result;
}

}  // namespace anisoquad
