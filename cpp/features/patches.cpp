#include "features/patches.h"

#include "mesh/face_components.h"

namespace anisoquad {

std::int32_t find_patches(SurfaceMesh& mesh) {
    const FaceComponents patches = face_components(
        mesh, [](Face) { return true; }, [&](Edge e) { return !mesh.is_constrained(e); });
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) mesh.info(Face(i)).patch = patches.of_face[static_cast<std::size_t>(i)];
    return patches.count();
}

}  // namespace anisoquad
