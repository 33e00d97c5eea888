#include "quality/distance.h"

#include <algorithm>
#include <array>
#include <vector>

namespace anisoquad {

double distance_to(const ReferenceSurface& surface, const SurfaceMesh& mesh) {
    double largest = 0.0;
    std::int32_t hint = -1;  // faces near each other in memory are near each other in space
    const auto look = [&](const Point& p) {
        const SurfacePoint closest = surface.closest(p, ReferenceSurface::kAnyPatch, hint);
        hint = closest.facet;
        largest = std::max(largest, closest.distance);
    };
    std::vector<char> seen(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        std::array<Point, 4> p;
        std::size_t n = 0;
        for (const HalfEdge h : mesh.halfedges(Face(i))) {
            p[n++] = mesh.position(mesh.from(h));
            const HalfEdge twin = SurfaceMesh::twin(h);
            if (h < twin || mesh.is_boundary(twin)) look(0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
            char& node_seen = seen[static_cast<std::size_t>(mesh.from(h).index())];
            if (!node_seen) look(mesh.position(mesh.from(h)));
            node_seen = 1;
        }
        look((p[0] + p[1] + p[2]) / 3.0);
        if (n < 4) continue;
        look((p[0] + p[2] + p[3]) / 3.0);
        look(0.5 * (p[0] + p[2]));
    }
    return largest;
}

}  // namespace anisoquad
