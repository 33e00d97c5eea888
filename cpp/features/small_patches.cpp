#include "features/small_patches.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/euler_operators.h"

namespace anisoquad {

std::int32_t refine_small_patches(SurfaceMesh& mesh) {
    const auto may_split = [&](HalfEdge side) {
        const Edge e = SurfaceMesh::edge(side);
        const HalfEdge across = SurfaceMesh::twin(side);
        return mesh.is_constrained(e) &&
               (mesh.is_boundary(across) || mesh.is_triangle(mesh.face(across)));
    };
    std::vector<Edge> edges;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i)) || !mesh.is_triangle(Face(i))) continue;
        const HalfEdge h = mesh.halfedge(Face(i));
        const std::array<HalfEdge, 3> sides{h, mesh.next(h), mesh.prev(h)};
        if (!std::all_of(sides.begin(), sides.end(), may_split)) continue;
        for (const HalfEdge side : sides) edges.push_back(SurfaceMesh::edge(side));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const Edge e : edges) {
        const HalfEdge h = SurfaceMesh::halfedge(e);
        split_edge(mesh, e, 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    }
    return static_cast<std::int32_t>(edges.size());
}

}  // namespace anisoquad
