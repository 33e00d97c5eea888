#include "qmorph/edge_recovery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/area_vector.h"
#include "mesh/euler_operators.h"
#include "mesh/flip_check.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr int kMostCrossed = 400;
constexpr int kMostRounds = 4;           // of taking nodes out of the way
constexpr double kTouching = 0.15;       // distance of a node from the line, over the line's length
constexpr double kInTheWay = 0.5;        // the same for a node that is taken away from it
constexpr double kLeastFold = 0.3;       // cosine between the triangles of a swapped edge
constexpr double kLeastTriangle = 0.02;  // of a triangle round a node that is pushed

class EdgeRecovery {
  public:
    EdgeRecovery(SurfaceMesh& mesh, Vertex a, Vertex b) : mesh_(mesh), a_(a), b_(b), line_(mesh.position(b) - mesh.position(a)) {}

    HalfEdge run() {
        const HalfEdge existing = mesh_.find_halfedge(a_, b_);
        if (existing.is_valid()) return existing;
        normal_ = fan_normal(a_).normalized() + fan_normal(b_).normalized();
        if (!(normal_.norm() > 0.1)) return {};
        normal_.normalize();
        if (!collect_crossed()) return {};
        // Once more in the mean plane of the strip itself, which the fans' normals only guess.
        if (strip_normal_.norm() > 0.0 && strip_normal_.normalized().dot(normal_) > 0.2) {
            const Vector3d guess = normal_;
            normal_ = strip_normal_.normalized();
            if (!collect_crossed()) {
                normal_ = guess;
                if (!collect_crossed()) return {};
            }
        }
        for (int round = 0;; ++round) {
            const HalfEdge made = swap_crossed();
            if (made.is_valid()) return made;
            if (round == kMostRounds || !collect_crossed() || !clear_line() || !collect_crossed())
                return mesh_.find_halfedge(a_, b_);
        }
    }

  private:
    const Point& at(Vertex v) const { return mesh_.position(v); }

    Vector3d fan_normal(Vertex v) const {
        Vector3d sum = Vector3d::Zero();
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (mesh_.is_boundary(h) || !mesh_.is_triangle(mesh_.face(h))) continue;
            sum += (at(mesh_.to(h)) - at(v)).cross(at(mesh_.to(mesh_.next(h))) - at(v));
        }
        return sum;
    }

    /// Positive if p lies left of the line.
    double side(Vertex v) const { return line_.cross(at(v) - at(a_)).dot(normal_); }
    double doubled_area(Vertex p, Vertex q, Vertex r) const { return (at(q) - at(p)).cross(at(r) - at(p)).dot(normal_); }

    bool can_swap_through(HalfEdge h) const {
        const Edge e = M::edge(h);
        return !mesh_.is_constrained(e) && mesh_.is_triangle(mesh_.face(h)) && mesh_.is_triangle(mesh_.face(M::twin(h)));
    }

    bool collect_crossed() {
        crossed_.clear();
        strip_normal_.setZero();
        HalfEdge crossing;
        for (const HalfEdge h : mesh_.outgoing(a_)) {
            if (mesh_.is_boundary(h) || !mesh_.is_triangle(mesh_.face(h))) continue;
            const HalfEdge opposite = mesh_.next(h);
            if (side(mesh_.from(opposite)) <= 0.0 && side(mesh_.to(opposite)) > 0.0 &&
                doubled_area(a_, mesh_.from(opposite), mesh_.to(opposite)) > 0.0) {
                crossing = opposite;
                break;
            }
        }
        if (!crossing.is_valid()) return false;
        while (static_cast<int>(crossed_.size()) < kMostCrossed) {
            if (!can_swap_through(crossing)) return false;
            strip_normal_ += doubled_area_vector(mesh_, mesh_.face(crossing));
            crossed_.push_back(M::edge(crossing));
            const HalfEdge across = M::twin(crossing);  // runs from the left of the line to its right
            const Vertex apex = mesh_.to(mesh_.next(across));
            if (apex == b_) {
                strip_normal_ += doubled_area_vector(mesh_, mesh_.face(across));
                return true;
            }
            // The crossing half-edge always runs from the right of the line to its left.
            crossing = side(apex) > 0.0 ? mesh_.next(across) : mesh_.prev(across);
        }
        return false;
    }

    /// The two triangles beside e form a strictly convex quadrilateral in the strip's plane.
    bool is_convex(Edge e) const {
        const HalfEdge h = M::halfedge(e);
        const Vertex p = mesh_.from(h);
        const Vertex q = mesh_.to(h);
        const Vertex l = mesh_.to(mesh_.next(h));
        const Vertex r = mesh_.to(mesh_.next(M::twin(h)));
        const double bound = 1e-6 * (at(p) - at(q)).squaredNorm() + 1e-6 * (at(l) - at(r)).squaredNorm();
        return doubled_area(p, r, l) > bound && doubled_area(q, l, r) > bound;
    }

    bool crosses(Edge e) const {
        const Vertex p = mesh_.from(M::halfedge(e));
        const Vertex q = mesh_.to(M::halfedge(e));
        if (p == a_ || p == b_ || q == a_ || q == b_) return false;
        return (side(p) > 0.0) != (side(q) > 0.0);
    }

    /// Free nodes that the line all but touches leave no convex pair to swap: they are pushed off it, or merged into an end or
    /// what else is beside them.
    bool clear_line() {
        bool changed = false;
        for (const Edge e : crossed_) {
            if (mesh_.is_deleted(e)) continue;
            for (const Vertex v : {mesh_.from(M::halfedge(e)), mesh_.to(M::halfedge(e))}) {
                if (mesh_.is_deleted(v) || !is_free(v)) continue;
                // No edge of a node inside of a triangle can be swapped.
                if (mesh_.valence(v) == 3) {
                    const HalfEdge out = mesh_.halfedge(v);
                    if (!is_collapse_ok(mesh_, out)) continue;
                    collapse(mesh_, out);
                    changed = true;
                    break;
                }
                const Vector3d offset = at(v) - at(a_);
                const double along = offset.dot(line_) / line_.squaredNorm();
                const Vector3d across = normal_.cross(line_).normalized();
                const double distance = offset.dot(across);
                if (along <= 0.0 || along >= 1.0 || std::abs(distance) > kInTheWay * line_.norm()) continue;
                if (std::abs(distance) > kTouching * line_.norm()) {
                    changed = merge_away(v, distance > 0.0) || changed;
                    if (mesh_.is_deleted(e)) break;
                    continue;
                }
                changed = push_off(v, (distance > 0.0 ? 1.0 : -1.0) * across, kTouching * line_.norm() - std::abs(distance)) ||
                          merge_into(v, along < 0.5 ? a_ : b_) || merge_away(v, distance > 0.0) || remove(v) || changed;
                if (mesh_.is_deleted(e)) break;
            }
        }
        return changed;
    }

    bool is_free(Vertex v) const {
        if (v == a_ || v == b_ || !is_movable(mesh_, v)) return false;
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (!mesh_.is_triangle(mesh_.face(h)) || mesh_.info(M::edge(h)).line >= 0) return false;
        }
        return true;
    }

    bool push_off(Vertex v, const Vector3d& direction, double way) {
        const Point kept = at(v);
        const Vector3d n = node_normal(mesh_, v);
        const Vector3d step = direction - direction.dot(n) * n;
        for (const double share : {1.5, 1.0, 0.6}) {
            mesh_.position(v) = kept + share * way * step;
            if (worst_quality(mesh_, v, n) > kLeastTriangle) {
                mesh_.info(v).input = -1;
                return true;
            }
        }
        mesh_.position(v) = kept;
        return false;
    }

    bool merge_into(Vertex v, Vertex end) {
        const HalfEdge h = mesh_.find_halfedge(v, end);
        if (!h.is_valid() || !is_collapse_ok(mesh_, h)) return false;
        for (const HalfEdge out : mesh_.outgoing(v)) {
            if (mesh_.to(out) == end || mesh_.to(mesh_.next(out)) == end) continue;
            const Vertex p = mesh_.to(out);
            const Vertex q = mesh_.to(mesh_.next(out));
            if (doubled_area(end, p, q) <= 0.0) return false;
        }
        collapse(mesh_, h);
        return true;
    }

    /// Of a triangle seen along the strip's normal: doubled area over the sum of squared edges.
    double quality_of(Vertex p, Vertex q, Vertex r) const {
        return doubled_area(p, q, r) /
               ((at(q) - at(p)).squaredNorm() + (at(r) - at(q)).squaredNorm() + (at(p) - at(r)).squaredNorm());
    }

    /// Worst triangle that a merge would leave.
    double worst_after_merge(HalfEdge h) const {
        const Vertex end = mesh_.to(h);
        double worst = 1.0;
        for (const HalfEdge out : mesh_.outgoing(mesh_.from(h))) {
            const Vertex p = mesh_.to(out);
            const Vertex q = mesh_.to(mesh_.next(out));
            if (p == end || q == end) continue;
            worst = std::min(worst, quality_of(end, p, q));
        }
        return worst;
    }

    /// Takes out a node among others that all but lie on the line, by swaps that leave it with three edges; where none can be
    /// swapped any more, by a merge.
    bool remove(Vertex v) {
        while (mesh_.valence(v) > 3) {
            Edge best;
            double quality = 1e-6;
            for (const HalfEdge out : mesh_.outgoing(v)) {
                const Vertex q = mesh_.to(out);
                const Vertex l = mesh_.to(mesh_.next(out));
                const Vertex r = mesh_.to(mesh_.next(M::twin(out)));
                const double here = quality_of(q, l, r);
                if (here <= quality || doubled_area(v, r, l) <= 0.0 || !is_flip_ok(mesh_, M::edge(out))) continue;
                quality = here;
                best = M::edge(out);
            }
            if (!best.is_valid()) return merge_best(v);
            flip(mesh_, best);
        }
        return merge_best(v);
    }

    /// Merges a node into the neighbour that leaves the best triangles.
    bool merge_best(Vertex v) {
        HalfEdge best;
        double quality = 0.0;
        for (const HalfEdge out : mesh_.outgoing(v)) {
            const double here = worst_after_merge(out);
            if (here <= quality || !is_collapse_ok(mesh_, out)) continue;
            quality = here;
            best = out;
        }
        if (!best.is_valid()) return false;
        collapse(mesh_, best);
        return true;
    }

    /// Merges a node into a neighbour on its own side of the line.
    bool merge_away(Vertex v, bool left) {
        std::vector<Vertex> ends;
        for (const HalfEdge out : mesh_.outgoing(v)) {
            const Vertex w = mesh_.to(out);
            if (w != a_ && w != b_ && (side(w) > 0.0) == left && std::abs(side(w)) > std::abs(side(v))) ends.push_back(w);
        }
        for (const Vertex w : ends) {
            if (merge_into(v, w)) return true;
        }
        return false;
    }

    HalfEdge swap_crossed() {
        const std::size_t tries = 20 + 6 * crossed_.size() * crossed_.size();
        std::size_t done = 0;
        for (std::size_t i = 0; i < crossed_.size(); ++i) {
            if (++done > tries) break;
            const Edge e = crossed_[i];
            if (!is_convex(e) || !is_flip_ok(mesh_, e) || !flip_keeps_surface(mesh_, e, kLeastFold)) {
                crossed_.push_back(e);
                continue;
            }
            flip(mesh_, e);
            if (crosses(e)) crossed_.push_back(e);
        }
        return mesh_.find_halfedge(a_, b_);
    }

    SurfaceMesh& mesh_;
    Vertex a_;
    Vertex b_;
    Vector3d line_;
    Vector3d normal_ = Vector3d::Zero();
    Vector3d strip_normal_ = Vector3d::Zero();
    static thread_local std::vector<Edge> crossed_;
};

thread_local std::vector<Edge> EdgeRecovery::crossed_;

}  // namespace

HalfEdge recover_edge(SurfaceMesh& mesh, Vertex a, Vertex b) { return EdgeRecovery(mesh, a, b).run(); }

}  // namespace anisoquad
