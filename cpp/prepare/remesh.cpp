#include "prepare/remesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/euler_operators.h"
#include "mesh/flip_check.h"
#include "prepare/collapse_check.h"
#include "smoothing/laplacian.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kLong = 1.45;
constexpr double kLeastFold = 0.8;  // cosine between the triangles of a swapped edge, see flip_keeps_surface()
constexpr double kShort = 0.85;

bool is_in(std::span<const char> patches, std::int32_t patch) {
    return patches.empty() || patches[static_cast<std::size_t>(patch)] != 0;
}

/// Asks every now and then whether to go on. @throws Error{cancelled}
void breathe(const RemeshOptions& options, std::int32_t step) {
    if (options.context && step % 2048 == 0) options.context->breathe();
}

/// Cosine and sine of the angle at r in the triangle p q r.
void opposite_angle(const Point& p, const Point& q, const Point& r, double& cosine, double& sine) {
    const Vector3d a = p - r;
    const Vector3d b = q - r;
    cosine = a.dot(b);
    sine = a.cross(b).norm();
}

/// Swaps one edge if that makes it Delaunay and keeps the surface.
bool flip_towards_delaunay(SurfaceMesh& mesh, Edge e, const ReferenceSurface& reference, const RemeshOptions& options,
                           std::int32_t& hint) {
    const HalfEdge h = M::halfedge(e);
    if (mesh.is_constrained(e) || !mesh.is_triangle(mesh.face(h)) || !mesh.is_triangle(mesh.face(M::twin(h)))) return false;
    if (!is_in(options.patches, mesh.info(mesh.face(h)).patch)) return false;
    const Point& p = mesh.position(mesh.from(h));
    const Point& q = mesh.position(mesh.to(h));
    const Point& l = mesh.position(mesh.to(mesh.next(h)));
    const Point& r = mesh.position(mesh.to(mesh.next(M::twin(h))));
    double cl = 0.0, sl = 0.0, cr = 0.0, sr = 0.0;
    opposite_angle(p, q, l, cl, sl);
    opposite_angle(p, q, r, cr, sr);
    // sin(angle sum) < 0: the sum is above π.
    const double scale = std::sqrt((cl * cl + sl * sl) * (cr * cr + sr * sr));
    if (sl * cr + cl * sr > -1e-6 * scale) return false;
    // Only now, since it goes round the nodes, and most edges are Delaunay's.
    if (!is_flip_ok(mesh, e) || !flip_keeps_surface(mesh, e, kLeastFold)) return false;
    const std::int32_t patch = mesh.info(mesh.face(h)).patch;
    const SurfacePoint now = reference.closest(0.5 * (p + q), patch, hint);
    hint = now.facet;
    if (reference.closest(0.5 * (l + r), patch, hint).distance > std::max(options.deviation * reference.diagonal(), now.distance))
        return false;
    if (!options.coverage) {
        flip(mesh, e);
        return true;
    }
    options.coverage->lift(mesh, e);
    const std::array<Coverage::Triangle, 2> after{{{p, r, l}, {q, l, r}}};
    const bool covered = options.coverage->is_covered_by(after);
    if (covered) flip(mesh, e);
    options.coverage->drop(mesh, e);
    return covered;
}

class Remesh {
  public:
    Remesh(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference, const RemeshOptions& options)
        : mesh_(mesh),
          zone_(zone),
          reference_(reference),
          options_(options),
          deviation_(options.deviation * reference.diagonal()) {}

    RemeshResult run() {
        for (int i = 0; i < options_.sweeps; ++i) {
            const RemeshResult before = result_;
            collapse_short();
            split_long();
            result_.flips += swap_towards_delaunay(mesh_, zone_, reference_, options_);
            relax();
            if (result_.splits == before.splits && result_.collapses == before.collapses && i > 0) break;
        }
        return result_;
    }

  private:
    const Point& at(Vertex v) const { return mesh_.position(v); }
    bool in_zone(Vertex v) const {
        return v.index() < static_cast<std::int32_t>(zone_.size()) && zone_[static_cast<std::size_t>(v.index())];
    }
    double wanted(Edge e) const {
        const HalfEdge h = M::halfedge(e);
        return kTriangleEdge * 0.5 * (mesh_.info(mesh_.from(h)).size + mesh_.info(mesh_.to(h)).size);
    }

    /// An edge between two unmeshed triangles, both ends in the zone or one in it.
    bool is_candidate(Edge e) const {
        if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) return false;
        const HalfEdge h = M::halfedge(e);
        if (!in_zone(mesh_.from(h)) && !in_zone(mesh_.to(h))) return false;
        if (!is_in(options_.patches, mesh_.info(mesh_.face(h)).patch)) return false;
        return mesh_.is_triangle(mesh_.face(h)) && mesh_.is_triangle(mesh_.face(M::twin(h)));
    }

    /// A node that may vanish: inside the triangles, on no line and no front.
    bool is_free(Vertex v) const {
        if (!in_zone(v) || !is_movable(mesh_, v)) return false;
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (!mesh_.is_triangle(mesh_.face(h))) return false;
        }
        return true;
    }

    void collapse_short() {
        std::vector<std::pair<double, Edge>> edges;
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (!is_candidate(Edge(i))) continue;
            const double ratio = mesh_.length(Edge(i)) / wanted(Edge(i));
            if (ratio < kShort) edges.emplace_back(ratio, Edge(i));
        }
        std::sort(edges.begin(), edges.end());
        std::int32_t step = 0;
        for (const auto& [ratio, e] : edges) {
            breathe(options_, ++step);
            if (!is_candidate(e) || mesh_.length(e) >= kShort * wanted(e)) continue;
            const HalfEdge h = M::halfedge(e);
            if (try_collapse(h) || try_collapse(M::twin(h))) ++result_.collapses;
        }
    }

    bool try_collapse(HalfEdge h) {
        return is_free(mesh_.from(h)) && anisoquad::try_collapse(mesh_, h, reference_, deviation_, options_.coverage);
    }

    void split_long() {
        const std::int32_t last = mesh_.edge_slots();
        std::vector<std::pair<double, Edge>> edges;
        for (std::int32_t i = 0; i < last; ++i) {
            if (!is_candidate(Edge(i))) continue;
            const double ratio = mesh_.length(Edge(i)) / wanted(Edge(i));
            if (ratio > kLong) edges.emplace_back(-ratio, Edge(i));
        }
        std::sort(edges.begin(), edges.end());
        std::int32_t step = 0;
        for (const auto& [ratio, e] : edges) {
            breathe(options_, ++step);
            if (mesh_.face_count() >= options_.most_triangles) return;
            if (!is_candidate(e) || mesh_.length(e) <= kLong * wanted(e)) continue;
            const HalfEdge h = M::halfedge(e);
            const Vertex v = split_covered_edge(mesh_, e, 0.5 * (at(mesh_.from(h)) + at(mesh_.to(h))), options_.coverage);
            if (static_cast<std::size_t>(mesh_.vertex_slots()) > zone_.size())
                zone_.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
            zone_[static_cast<std::size_t>(v.index())] = 1;
            std::int32_t hint = -1;
            const Point kept = at(v);
            mesh_.position(v) =
                reference_.project(kept, {mesh_.info(mesh_.face(mesh_.halfedge(v))).patch, node_normal(mesh_, v)}, hint);
            if (worst_quality(mesh_, v, node_normal(mesh_, v)) <= 0.0) mesh_.position(v) = kept;
            ++result_.splits;
            swap_round(v);
        }
    }

    /// Swaps opposite to a new node as far as they go (Lawson): long thin triangles are not cut into ever thinner ones.
    void swap_round(Vertex v) {
        stack_.clear();
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (!mesh_.is_boundary(h)) stack_.push_back(M::edge(mesh_.next(h)));
        }
        std::int32_t hint = -1;
        while (!stack_.empty()) {
            const Edge e = stack_.back();
            stack_.pop_back();
            if (!is_candidate(e)) continue;
            const HalfEdge h = M::halfedge(e);
            const HalfEdge far = mesh_.to(mesh_.next(h)) == v ? M::twin(h) : h;
            if (mesh_.to(mesh_.next(M::twin(far))) != v) continue;
            const Edge first = M::edge(mesh_.next(far));
            const Edge second = M::edge(mesh_.prev(far));
            if (!flip_towards_delaunay(mesh_, e, reference_, options_, hint)) continue;
            ++result_.flips;
            stack_.push_back(first);
            stack_.push_back(second);
        }
    }

    void relax() {
        std::int32_t hint = -1;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            breathe(options_, i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || !is_free(v)) continue;
            Point target;
            if (!laplacian_target(mesh_, v, target)) continue;
            const Point kept = at(v);
            const std::int32_t input = mesh_.info(v).input;
            if (options_.coverage) options_.coverage->lift(mesh_, v);
            const bool moved = move_node(mesh_, v, target, &reference_, &hint);
            if (moved && options_.coverage && !options_.coverage->is_covered_round(mesh_, v)) {
                mesh_.position(v) = kept;
                mesh_.info(v).input = input;
            } else {
                result_.moves += moved;
            }
            if (options_.coverage) options_.coverage->drop(mesh_, v);
        }
    }

    SurfaceMesh& mesh_;
    std::vector<char>& zone_;
    const ReferenceSurface& reference_;
    const RemeshOptions& options_;
    double deviation_;
    RemeshResult result_;
    std::vector<Edge> stack_;
};

}  // namespace

std::int32_t swap_towards_delaunay(SurfaceMesh& mesh, const std::vector<char>& zone, const ReferenceSurface& reference,
                                   const RemeshOptions& options) {
    std::int32_t hint = -1;
    std::int32_t flips = 0;
    const auto inside = [&](Vertex v) {
        return v.index() < static_cast<std::int32_t>(zone.size()) && zone[static_cast<std::size_t>(v.index())];
    };
    for (int sweep = 0; sweep < 4; ++sweep) {
        const std::int32_t before = flips;
        for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
            const Edge e(i);
            breathe(options, i);
            if (mesh.is_deleted(e) || mesh.is_constrained(e)) continue;
            const HalfEdge h = M::halfedge(e);
            if (!inside(mesh.from(h)) && !inside(mesh.to(h))) continue;
            flips += flip_towards_delaunay(mesh, e, reference, options, hint);
        }
        if (flips == before) break;
    }
    return flips;
}

RemeshResult remesh_triangles(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference,
                              const RemeshOptions& options) {
    return Remesh(mesh, zone, reference, options).run();
}

}  // namespace anisoquad
