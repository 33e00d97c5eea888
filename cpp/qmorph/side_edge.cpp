#include "qmorph/side_edge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/euler_operators.h"
#include "mesh/flip_check.h"
#include "qmorph/front.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = kPi / 6;     // Owen: an edge this close to the wanted direction is taken as it is
constexpr double kLongest = 0.8660254038;  // Owen: √3/2 of the mean front edge bounds a swapped edge… times two
constexpr double kLeastFold = 0.3;         // cosine between the triangles of a swapped edge
constexpr double kLeastSplit = 0.05;       // length of a split edge over the wanted size
constexpr int kLoopLimit = 1 << 20;

double corner(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

class SideEdge {
  public:
    SideEdge(SurfaceMesh& mesh, HalfEdge h, End end, Vertex avoid) : mesh_(mesh), avoid_(avoid) {
        // The sector lies between the front edge `in_`, which ends at the node, and the one that leaves it.
        in_ = end == End::right ? h : previous_front(mesh, h);
        out_ = next_front(mesh, in_);
        node_ = mesh.to(in_);
        angle_ = front_angle(mesh, in_);
        const double parts = angle_ > 1.25 * kPi ? std::round(angle_ / (kPi / 2)) : 2.0;
        wanted_ = end == End::right ? angle_ / parts : angle_ * (parts - 1) / parts;
        mean_length_ = 0.5 * (mesh.length(in_) + mesh.length(out_));
        end_ = end;
    }

    HalfEdge run() {
        if (angle_ < kSideAngle) return end_ == End::right ? out_ : M::twin(in_);
        HalfEdge best = closest_edge();
        if (best.is_valid() && deviation_ < kTolerance && is_usable(best)) return best;
        const HalfEdge swapped = swap();
        if (swapped.is_valid()) return swapped;
        const HalfEdge split = split_crossed();
        if (split.is_valid()) return split;
        // As a way out the closest edge that is usable at all, up to 60° off.
        return usable_within(kPi / 3);
    }

  private:
    const Point& at(Vertex v) const { return mesh_.position(v); }
    Vector3d direction(Vertex v) const { return at(v) - at(node_); }

    /// Calls visit(spoke, angle from the incoming front edge) for the edges inside the sector.
    template <class Visit>
    void for_each_spoke(Visit visit) const {
        double sum = 0.0;
        HalfEdge in = in_;
        while (true) {
            const HalfEdge spoke = mesh_.next(in);
            sum += corner(direction(mesh_.from(in)), direction(mesh_.to(spoke)));
            if (is_front(mesh_, spoke)) return;
            visit(spoke, sum);
            in = M::twin(spoke);
        }
    }

    HalfEdge closest_edge() {
        HalfEdge best;
        deviation_ = 1e30;
        for_each_spoke([&](HalfEdge spoke, double angle) {
            const double deviation = std::abs(angle - wanted_);
            if (deviation < deviation_) {
                deviation_ = deviation;
                best = spoke;
            }
        });
        return best;
    }

    HalfEdge usable_within(double bound) {
        HalfEdge best;
        double best_deviation = bound;
        for_each_spoke([&](HalfEdge spoke, double angle) {
            const double deviation = std::abs(angle - wanted_);
            if (deviation < best_deviation && closes_well(spoke) && mesh_.to(spoke) != avoid_) {
                best_deviation = deviation;
                best = spoke;
            }
        });
        return best;
    }

    /// False for edges far longer than the front, and for those that would leave loops of odd length.
    bool is_usable(HalfEdge spoke) const {
        if (mesh_.to(spoke) == avoid_) return false;
        if (!closes_well(spoke)) return false;
        const bool reaches_front = front_into(mesh_, M::twin(spoke)).is_valid();
        return reaches_front || mesh_.length(spoke) < 2.0 * mean_length_;
    }

    /// A side edge that ends on the front splits its loop in two, which must both be even. Of one that goes along a cut this can
    /// not be known.
    bool closes_well(HalfEdge spoke) const {
        const HalfEdge in = front_into(mesh_, M::twin(spoke));
        if (!in.is_valid()) return true;
        const FrontWay ahead = front_way(mesh_, out_, in, kLoopLimit);
        if (ahead.edges < 0) return true;  // another loop: the two become one
        const FrontWay behind = front_way(mesh_, next_front(mesh_, in), in_, kLoopLimit);
        const auto is_even = [](const FrontWay& way) { return way.along_cut || (way.edges % 2 == 1 && way.edges >= 3); };
        const bool is_known = !ahead.along_cut && !behind.along_cut;
        if (is_known && (ahead.edges + behind.edges) % 2 != 0) return true;  // other loops of the patch make up for it
        return is_even(ahead) && is_even(behind);
    }

    /// The triangle of the sector in which the wanted direction lies: the half-edge opposite to the node.
    HalfEdge crossed_edge(double& fraction) const {
        double sum = 0.0;
        HalfEdge in = in_;
        while (true) {
            const HalfEdge spoke = mesh_.next(in);
            const double here = corner(direction(mesh_.from(in)), direction(mesh_.to(spoke)));
            if (sum + here >= wanted_ || is_front(mesh_, spoke)) {
                // Where a ray at angle x from the first side meets the opposite edge (law of sines).
                const double x = std::clamp(wanted_ - sum, 0.0, here);
                const double p = direction(mesh_.from(in)).norm() * std::sin(x);
                const double q = direction(mesh_.to(spoke)).norm() * std::sin(here - x);
                fraction = p + q > 0.0 ? p / (p + q) : 0.5;
                return mesh_.next(spoke);  // runs from the spoke's end back to from(in)
            }
            sum += here;
            in = M::twin(spoke);
        }
    }

    HalfEdge swap() {
        double fraction = 0.5;
        const HalfEdge opposite = crossed_edge(fraction);
        const Edge e = M::edge(opposite);
        if (is_front(mesh_, M::twin(opposite)) || is_front(mesh_, opposite) || !is_flip_ok(mesh_, e)) return {};
        if (!flip_keeps_surface(mesh_, e, kLeastFold)) return {};
        const Vertex apex = mesh_.to(mesh_.next(M::twin(opposite)));
        const Vertex left = mesh_.from(opposite);
        const Vertex right = mesh_.to(opposite);
        if (direction(apex).norm() > 2.0 * kLongest * mean_length_) return {};
        const Vector3d a = direction(right);
        const Vector3d b = direction(left);
        const Vector3d c = direction(apex);
        // Convex in the mean plane of the two triangles, and close to the wanted direction.
        const Vector3d normal = b.cross(a) + (at(apex) - at(left)).cross(at(right) - at(left));
        const Vector3d n = normal.dot(b.cross(a)) > 0.0 ? normal : Vector3d(b.cross(a));
        if (b.cross(c).dot(n) <= 1e-3 * n.squaredNorm() || c.cross(a).dot(n) <= 1e-3 * n.squaredNorm()) return {};
        double start = 0.0;
        for_each_spoke([&](HalfEdge spoke, double angle) {
            if (mesh_.to(spoke) == right) start = angle;
        });
        if (std::abs(start + corner(a, c) - wanted_) > kTolerance) return {};
        flip(mesh_, e);
        const HalfEdge spoke = mesh_.find_halfedge(node_, apex);
        if (is_usable(spoke)) return spoke;
        return {};
    }

    /// Far shorter edges than wanted are not split: where the surface is folded over, that would go on and on.
    bool may_split(HalfEdge h) const {
        return mesh_.length(h) >= kLeastSplit * std::max(mesh_.info(mesh_.from(h)).size, mesh_.info(mesh_.to(h)).size);
    }

    HalfEdge split_crossed() {
        double fraction = 0.5;
        const HalfEdge opposite = crossed_edge(fraction);
        if (is_front(mesh_, opposite) || mesh_.is_constrained(M::edge(opposite)) || is_front(mesh_, M::twin(opposite))) {
            return split_spoke();
        }
        if (!may_split(opposite)) return {};
        fraction = std::clamp(fraction, 0.15, 0.85);
        const Point p = at(mesh_.to(opposite)) + fraction * (at(mesh_.from(opposite)) - at(mesh_.to(opposite)));
        if ((p - at(node_)).norm() < 0.25 * mean_length_) return {};
        const Vertex v = split_edge(mesh_, M::edge(opposite), p);
        const HalfEdge spoke = mesh_.find_halfedge(node_, v);
        if (mesh_.length(spoke) <= 1.5 * mean_length_) return spoke;
        const Vertex nearer =
            split_edge(mesh_, M::edge(spoke), at(node_) + (p - at(node_)) * (mean_length_ / (p - at(node_)).norm()));
        return mesh_.find_halfedge(node_, nearer);
    }

    /// Where the sector's triangle ends on the front: the closest spoke is split in its middle.
    HalfEdge split_spoke() {
        const HalfEdge spoke = closest_edge();
        if (!spoke.is_valid() || deviation_ > kPi / 3 || mesh_.is_constrained(M::edge(spoke)) || !may_split(spoke)) return {};
        const Vertex v = split_edge(mesh_, M::edge(spoke), 0.5 * (at(node_) + at(mesh_.to(spoke))));
        return mesh_.find_halfedge(node_, v);
    }

    SurfaceMesh& mesh_;
    Vertex avoid_;
    HalfEdge in_;
    HalfEdge out_;
    Vertex node_;
    End end_ = End::right;
    double angle_ = 0.0;
    double wanted_ = 0.0;
    double mean_length_ = 0.0;
    double deviation_ = 0.0;
};

}  // namespace

HalfEdge choose_side_edge(SurfaceMesh& mesh, HalfEdge h, End end, Vertex avoid) { return SideEdge(mesh, h, end, avoid).run(); }

}  // namespace anisoquad
