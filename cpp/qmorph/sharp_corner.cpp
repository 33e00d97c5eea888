#include "qmorph/sharp_corner.h"

#include <vector>

#include "mesh/euler_operators.h"
#include "qmorph/edge_recovery.h"
#include "qmorph/front.h"
#include "qmorph/quad_formation.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kSharp = 0.8;      // radians
constexpr double kBeyond = 0.3;     // way of the new node beyond the middle of U – L, over the length of U – L
constexpr double kEvenSides = 2.5;  // ratio of the corner's edges up to which they belong together

/// A front edge on a line or on top of an anisotropic row: no seam may take it.
bool is_fixed(const SurfaceMesh& mesh, HalfEdge h) {
    const Face behind = mesh.face(M::twin(h));
    return mesh.is_constrained(M::edge(h)) || (behind.is_valid() && mesh.info(behind).row > 0);
}

bool fill_corner(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge following = next_front(mesh, h);
    const Vertex u = mesh.from(h);
    const Vertex c = mesh.to(h);
    const Vertex l = mesh.to(following);
    if (loop_length(mesh, h, 5) <= 5) return false;
    const HalfEdge across = recover_edge(mesh, l, u);
    if (!across.is_valid() || mesh.is_constrained(M::edge(across)) || is_front(mesh, across) || is_front(mesh, M::twin(across)))
        return false;
    const Point middle = 0.5 * (mesh.position(u) + mesh.position(l));
    const Vertex x = split_edge(mesh, M::edge(across), middle);
    const Eigen::Vector3d outward =
        kBeyond * (mesh.position(u) - mesh.position(l)).norm() * (middle - mesh.position(c)).normalized();
    for (const double share : {1.0, 0.5, 0.25}) {
        mesh.position(x) = middle + share * outward;
        if (worst_quality(mesh, x, node_normal(mesh, x)) > 0.0) break;
        mesh.position(x) = middle;
    }
    return form_quad(mesh, following, x, u, -1.0).is_valid();
}

}  // namespace

int fill_sharp_corners(SurfaceMesh& mesh, const Cuts& cuts) {
    int filled = 0;
    const std::int32_t last = mesh.halfedge_slots();
    for (std::int32_t i = 0; i < last; ++i) {
        const HalfEdge h(i);
        if (mesh.is_deleted(h) || !is_front(mesh, h) || front_angle(mesh, h) > kSharp) continue;
        const HalfEdge following = next_front(mesh, h);
        if (!is_fixed(mesh, h) || !is_fixed(mesh, following)) continue;
        if (is_near_cut(mesh, h, cuts) || is_near_cut(mesh, following, cuts)) continue;
        const double ratio = mesh.length(h) / mesh.length(following);
        if (ratio > kEvenSides || ratio < 1.0 / kEvenSides) continue;
        filled += fill_corner(mesh, h);
    }
    return filled;
}

}  // namespace anisoquad
