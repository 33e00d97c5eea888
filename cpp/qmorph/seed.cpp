#include "qmorph/seed.h"

#include <vector>

#include "mesh/euler_operators.h"
#include "qmorph/front.h"
#include "quality/metrics.h"

namespace anisoquad {

using M = SurfaceMesh;

int start_closed_components(SurfaceMesh& mesh) {
    int seeds = 0;
    std::vector<char> seen(static_cast<std::size_t>(mesh.face_slots()), 0);
    std::vector<Face> component;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i)) || seen[static_cast<std::size_t>(i)] || !mesh.is_triangle(Face(i))) continue;
        component.assign(1, Face(i));
        seen[static_cast<std::size_t>(i)] = 1;
        bool has_front = false;
        Edge best;
        double best_quality = -2.0;
        for (std::size_t k = 0; k < component.size(); ++k) {
            for (const HalfEdge h : mesh.halfedges(component[k])) {
                if (is_front(mesh, h)) {
                    has_front = true;
                    continue;
                }
                const HalfEdge g = M::twin(h);
                if (!has_front) {  // else no seed is wanted
                    const double q = scaled_jacobian_of_pair(mesh, h);
                    if (q > best_quality) {
                        best_quality = q;
                        best = M::edge(h);
                    }
                }
                const Face other = mesh.face(g);
                if (seen[static_cast<std::size_t>(other.index())]) continue;
                seen[static_cast<std::size_t>(other.index())] = 1;
                component.push_back(other);
            }
        }
        if (has_front || !best.is_valid()) continue;
        dissolve_edge(mesh, best);
        ++seeds;
    }
    return seeds;
}

}  // namespace anisoquad
