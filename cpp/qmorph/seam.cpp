#include "qmorph/seam.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/euler_operators.h"
#include "qmorph/edge_recovery.h"
#include "qmorph/front.h"
#include "qmorph/quad_formation.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kSeamAngle = std::numbers::pi / 6;
constexpr double kSeamAngleCrowded = std::numbers::pi / 4;  // at a node that already has five quads
constexpr double kTransitionRatio = 2.5;
constexpr double kLongEdge = 1.85;                    // over the wanted size: halved even without a step of length
constexpr double kLeastNotch = std::numbers::pi / 4;  // a sharper notch would be seamed again at once
constexpr double kLeastHalved = 1.3;  // over the wanted size: shorter edges are never halved, so that no seam undoes a split

int quads_at(const SurfaceMesh& mesh, Vertex v) {
    int n = 0;
    for (const HalfEdge h : mesh.outgoing(v)) n += !mesh.is_boundary(h) && mesh.is_quad(mesh.face(h));
    return n;
}

/// R, the other neighbour, in the quad behind the front edge, of the end N at which the edge is cut: its to() when `at_end`.
Vertex node_behind(const SurfaceMesh& mesh, HalfEdge front, bool at_end) {
    const HalfEdge back = M::twin(front);
    return at_end ? mesh.from(mesh.prev(back)) : mesh.to(mesh.next(back));
}

/// The edge may be halved: behind it lies a quad that belongs to no row, it is on no line, and neither is the quad's side at
/// the end where the triangle is cut off (a seam there could only undo it). Nor is the triangle's apex a node of that side:
/// the middle would be joined to it twice.
bool can_halve(const SurfaceMesh& mesh, HalfEdge front, bool at_end) {
    const HalfEdge back = M::twin(front);
    if (mesh.is_constrained(M::edge(front)) || mesh.is_constrained(M::edge(at_end ? mesh.prev(back) : mesh.next(back))))
        return false;
    const double size = 0.5 * (mesh.info(mesh.from(front)).size + mesh.info(mesh.to(front)).size);
    if (mesh.length(front) < kLeastHalved * size) return false;
    if (!mesh.is_quad(mesh.face(back)) || mesh.info(mesh.face(back)).row > 0) return false;
    return mesh.to(mesh.next(front)) != node_behind(mesh, front, at_end);
}

/// Angle of the notch that a transition split leaves in the front: at R between the halved edge's middle and its end.
double notch_angle(const SurfaceMesh& mesh, HalfEdge front, bool at_end) {
    const Point& end = mesh.position(at_end ? mesh.to(front) : mesh.from(front));
    const Point& r = mesh.position(node_behind(mesh, front, at_end));
    const Eigen::Vector3d a = 0.5 * (mesh.position(mesh.from(front)) + mesh.position(mesh.to(front))) - r;
    const Eigen::Vector3d b = end - r;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Halves the front edge of the quad P N R S (front runs P → N when `at_end`, N → P otherwise) and cuts the triangle M N R off.
/// @returns M; `apex` receives R
Vertex halve(SurfaceMesh& mesh, HalfEdge front, bool at_end, Vertex& apex) {
    const HalfEdge back = M::twin(front);
    apex = node_behind(mesh, front, at_end);
    const Point middle = 0.5 * (mesh.position(mesh.from(front)) + mesh.position(mesh.to(front)));
    const FaceInfo info = mesh.info(mesh.face(back));
    const Vertex m = insert_vertex(mesh, M::edge(front), middle);
    // The triangle before the front has become a four-sided face; join M with its apex.
    for (const HalfEdge out : mesh.outgoing(m)) {
        const int sides = mesh.valence(mesh.face(out));
        if (sides == 4) {
            insert_edge(mesh, out, mesh.next(mesh.next(out)));
            break;
        }
    }
    HalfEdge from_m;
    HalfEdge from_r;
    for (const HalfEdge out : mesh.outgoing(m)) {
        if (mesh.valence(mesh.face(out)) == 5) from_m = out;
    }
    for (const HalfEdge k : mesh.halfedges(mesh.face(from_m))) {
        if (mesh.from(k) == apex) from_r = k;
    }
    const HalfEdge cut = insert_edge(mesh, from_m, from_r);
    mesh.info(mesh.face(cut)) = info;
    mesh.info(mesh.face(M::twin(cut))) = info;
    return m;
}

}  // namespace

SeamKind classify_seam(const SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge following = next_front(mesh, h);
    const Vertex p = mesh.from(h);
    const Vertex q = mesh.to(following);
    if (p == q) return SeamKind::none;
    const double l1 = mesh.length(h);
    const double l2 = mesh.length(following);
    const double ratio = std::max(l1, l2) / std::min(l1, l2);
    const HalfEdge longer = l1 > l2 ? h : following;
    const double angle = front_angle(mesh, h);
    const double bound = quads_at(mesh, mesh.to(h)) >= 5 ? kSeamAngleCrowded : kSeamAngle;
    if (angle < bound) {
        if (ratio <= kTransitionRatio) return is_movable(mesh, p) || is_movable(mesh, q) ? SeamKind::seam : SeamKind::none;
        return can_halve(mesh, longer, longer == h) ? SeamKind::transition_seam : SeamKind::none;
    }
    const double size = 0.5 * (mesh.info(mesh.from(longer)).size + mesh.info(mesh.to(longer)).size);
    const bool step = ratio > kTransitionRatio || (size > 0.0 && std::max(l1, l2) > kLongEdge * size);
    if (step && angle > std::numbers::pi * 0.6 && can_halve(mesh, longer, longer == h) &&
        notch_angle(mesh, longer, longer == h) > kLeastNotch) {
        return SeamKind::transition_split;
    }
    return SeamKind::none;
}

Vertex seam(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge following = next_front(mesh, h);
    Vertex gone = mesh.from(h);
    Vertex kept = mesh.to(following);
    if (gone == kept) return {};
    if (!is_movable(mesh, gone)) std::swap(gone, kept);
    if (!is_movable(mesh, gone)) return {};
    const HalfEdge across = recover_edge(mesh, kept, gone);
    if (!across.is_valid()) return {};
    const HalfEdge inner = mesh.find_halfedge(mesh.to(following), mesh.from(h));
    const std::array<HalfEdge, 3> loop{h, following, inner};
    static thread_local std::vector<Face> faces;
    if (!mesh.face(inner).is_valid() || !collect_region(mesh, loop, faces)) return {};
    const HalfEdge outside = M::twin(inner);
    if (is_front(mesh, outside) || mesh.is_boundary(outside) || !mesh.is_triangle(mesh.face(outside))) return {};
    if (faces.size() > 1) replace_region(mesh, loop, faces);
    const HalfEdge ridge = mesh.find_halfedge(gone, kept);
    if (!is_collapse_ok(mesh, ridge)) return {};
    // Middle, or one of the ends: the first place that inverts nothing around.
    const Point p_gone = mesh.position(gone);
    const Point p_kept = mesh.position(kept);
    const Eigen::Vector3d n_gone = node_normal(mesh, gone);
    const Eigen::Vector3d n_kept = node_normal(mesh, kept);
    const double before = std::min(worst_quality(mesh, gone, n_gone), worst_quality(mesh, kept, n_kept));
    const bool middle_allowed = is_movable(mesh, kept);
    const std::array<double, 3> shares{0.5, 0.0, 1.0};
    const HalfEdge gone_spoke = ridge;
    for (const double share : shares) {
        if (!middle_allowed && share != 0.0) continue;
        const Point p = p_kept + share * (p_gone - p_kept);
        mesh.position(gone) = mesh.position(kept) = p;
        // The two triangles beside the ridge vanish: they count as degenerate (0), so the bound is just below.
        bool good = true;
        for (const Vertex v : {gone, kept}) {
            const Eigen::Vector3d& n = v == gone ? n_gone : n_kept;
            if (worst_quality(mesh, v, n) < std::min(-1e-9, before)) good = false;
        }
        if (!good) continue;
        mesh.position(gone) = p_gone;
        collapse(mesh, gone_spoke);
        mesh.position(kept) = p;
        return kept;
    }
    mesh.position(gone) = p_gone;
    mesh.position(kept) = p_kept;
    return {};
}

Face transition_seam(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge following = next_front(mesh, h);
    const bool first_longer = mesh.length(h) > mesh.length(following);
    const HalfEdge longer = first_longer ? h : following;
    if (!can_halve(mesh, longer, longer == h)) return {};
    const Vertex n = mesh.to(h);
    const Vertex q = first_longer ? mesh.to(following) : mesh.from(h);
    Vertex r;
    const Vertex m = halve(mesh, longer, first_longer, r);
    if (!recover_edge(mesh, q, m).is_valid()) return {};
    // Counter-clockwise around the gap.
    if (first_longer) return form_quad(mesh, mesh.find_halfedge(n, q), m, r, -1.0);
    return form_quad(mesh, mesh.find_halfedge(q, n), r, m, -1.0);
}

Vertex transition_split(SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge following = next_front(mesh, h);
    const bool first_longer = mesh.length(h) > mesh.length(following);
    const HalfEdge longer = first_longer ? h : following;
    if (!can_halve(mesh, longer, longer == h)) return {};
    Vertex r;
    return halve(mesh, longer, first_longer, r);
}

}  // namespace anisoquad
