#include "features/patches.h"

#include <vector>

namespace anisoquad {

std::int32_t find_patches(SurfaceMesh& mesh) {
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) mesh.info(Face(i)).patch = -1;
    std::int32_t patches = 0;
    std::vector<Face> stack;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i)) || mesh.info(Face(i)).patch >= 0) continue;
        mesh.info(Face(i)).patch = patches;
        stack.assign(1, Face(i));
        while (!stack.empty()) {
            const Face f = stack.back();
            stack.pop_back();
            for (const HalfEdge h : mesh.halfedges(f)) {
                if (mesh.is_constrained(SurfaceMesh::edge(h))) continue;
                const Face g = mesh.face(SurfaceMesh::twin(h));
                if (mesh.info(g).patch >= 0) continue;
                mesh.info(g).patch = patches;
                stack.push_back(g);
            }
        }
        ++patches;
    }
    return patches;
}

}  // namespace anisoquad
