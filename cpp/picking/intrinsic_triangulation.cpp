#include "picking/intrinsic_triangulation.h"

#include <algorithm>
#include <cmath>

namespace anisoquad {

IntrinsicTriangulation::IntrinsicTriangulation(const SurfaceMesh& mesh)
    : next_(static_cast<std::size_t>(mesh.halfedge_slots())),
      from_(next_.size()),
      length_(next_.size(), 0.0),
      direction_(next_.size(), 0.0),
      total_angle_(static_cast<std::size_t>(mesh.vertex_slots()), 0.0) {
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge h(i);
        if (mesh.is_deleted(h)) continue;
        from_[at(h)] = mesh.from(h);
        length_[at(h)] = mesh.length(h);
        if (!mesh.is_boundary(h)) next_[at(h)] = mesh.next(h);
    }
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !mesh.halfedge(v).is_valid()) continue;
        // Counter-clockwise. At the boundary halfedge(v) is the last one: it has no face on its left.
        HalfEdge h = mesh.halfedge(v);
        while (mesh.is_boundary(v) && !mesh.is_boundary(SurfaceMesh::twin(h))) h = mesh.rotated_cw(h);
        double sum = 0.0;
        const HalfEdge start = h;
        do {
            direction_[at(h)] = sum;
            if (!has_face(h)) break;
            sum += angle(h);
            h = twin(prev(h));
        } while (h != start);
        total_angle_[static_cast<std::size_t>(v.index())] = sum;
    }
}

double IntrinsicTriangulation::angle(HalfEdge h) const {
    const double a = length(h);
    const double b = length(prev(h));
    const double c = length(next(h));
    return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0));
}

void IntrinsicTriangulation::flip(HalfEdge h) {
    // a → b with c on the left and d on the right becomes d → c.
    const HalfEdge t = twin(h);
    const HalfEdge bc = next(h);
    const HalfEdge ca = prev(h);
    const HalfEdge ad = next(t);
    const HalfEdge db = prev(t);
    const double at_a = angle(h) + angle(ad);
    const double ac = length(ca);
    const double ad_length = length(ad);
    const double squared = ac * ac + ad_length * ad_length - 2.0 * ac * ad_length * std::cos(at_a);
    length_[at(h)] = length_[at(t)] = std::sqrt(std::max(squared, 0.0));
    from_[at(h)] = from(db);
    from_[at(t)] = from(ca);
    const auto link = [this](HalfEdge x, HalfEdge y, HalfEdge z) {
        next_[at(x)] = y;
        next_[at(y)] = z;
        next_[at(z)] = x;
    };
    link(h, ca, ad);
    link(t, db, bc);
    direction_[at(h)] = direction(db) + angle(db);
    direction_[at(t)] = direction(ca) + angle(ca);
}

}  // namespace anisoquad
