#include "features/ridges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/area_vector.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr int kMostFacets = 200;         ///< crossed on the way to one side
constexpr double kStraight = 0.5;        ///< least cosine between neighbouring edges of a ridge
constexpr double kImbalance = 0.7;       ///< largest difference of the two sides' turns, over their sum
constexpr double kGoingOn = 0.35;        ///< of the angle at which a ridge begins: where it may go on
constexpr double kLeastLength = 2.0;     ///< of a ridge over the width
constexpr double kSharpMeeting = 0.866;  ///< cosine of 30°, at which a ridge does not run into another line

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

class RidgeFinder {
  public:
    RidgeFinder(const SurfaceMesh& mesh, std::span<const char> patches, const RidgeOptions& options)
        : mesh_(mesh), patches_(patches), options_(options), folds_(static_cast<std::size_t>(mesh.edge_slots())) {}

    Ridges run() {
        ridges_.in_fold.assign(static_cast<std::size_t>(mesh_.edge_slots()), 0);
        used_.assign(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        is_ridge_.assign(static_cast<std::size_t>(mesh_.edge_slots()), 0);
        reached_.assign(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        std::vector<Edge> seeds;
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (measure(Edge(i))) seeds.push_back(Edge(i));
        }
        std::sort(seeds.begin(), seeds.end(), [&](Edge a, Edge b) {
            const double x = fold(a).turn * (1.0 - fold(a).imbalance);
            const double y = fold(b).turn * (1.0 - fold(b).imbalance);
            return x != y ? x > y : a < b;
        });
        // A source stands for the fold that it lies on.
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (!mesh_.is_deleted(Edge(i)) && mesh_.info(Edge(i)).source) shut(M::halfedge(Edge(i)));
        }
        for (const Edge e : seeds) grow(e);
        return std::move(ridges_);
    }

  private:
    struct Fold {
        bool is_candidate = false;
        double imbalance = 1.0;
        double turn = 0.0;
    };
    Fold& fold(Edge e) { return folds_[static_cast<std::size_t>(e.index())]; }
    const Point& at(Vertex v) const { return mesh_.position(v); }
    bool is_used(Vertex v) const { return used_[static_cast<std::size_t>(v.index())] != 0; }

    bool measure(Edge e) {
        if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) return false;
        const HalfEdge h = M::halfedge(e);
        if (patches_[static_cast<std::size_t>(mesh_.info(mesh_.face(h)).patch)] == 0) return false;
        const Vector3d left = doubled_area_vector(mesh_, mesh_.face(h)).normalized();
        const Vector3d right = doubled_area_vector(mesh_, mesh_.face(M::twin(h))).normalized();
        const Vector3d n = (left + right).normalized();
        const Vector3d along = (at(mesh_.to(h)) - at(mesh_.from(h))).normalized();
        // Only the turn about the edge counts: that is what folds the surface along it.
        const auto turn_about = [&](const Vector3d& m) { return angle_between(n, m - m.dot(along) * along); };
        const double a = turn_about(normal_aside(h));
        const double b = turn_about(normal_aside(M::twin(h)));
        const double turn = a + b;
        Fold& f = fold(e);
        f.turn = turn;
        f.imbalance = turn > 0.0 ? std::abs(a - b) / turn : 1.0;
        const double angle = options_.angle * std::numbers::pi / 180.0;
        f.is_candidate = turn > kGoingOn * angle;
        return turn > angle && f.imbalance < kImbalance;
    }

    /// Area vector of the facet at half the width from the middle of h, straight away from it on its face's side.
    Vector3d normal_aside(HalfEdge h) const {
        Point p = 0.5 * (at(mesh_.from(h)) + at(mesh_.to(h)));
        double left = 0.5 * options_.width;
        Vector3d normal = doubled_area_vector(mesh_, mesh_.face(h)).normalized();
        Vector3d along = (at(mesh_.to(h)) - at(mesh_.from(h))).normalized();
        Vector3d direction = normal.cross(along);
        for (int step = 0; step < kMostFacets; ++step) {
            // The facet's other two edges: out through the one that the line meets first.
            HalfEdge out;
            double way = 1e300;
            for (const HalfEdge k : {mesh_.next(h), mesh_.prev(h)}) {
                const Vector3d edge = at(mesh_.to(k)) - at(mesh_.from(k));
                const Vector3d inward = normal.cross(edge);
                const double speed = -direction.dot(inward);
                if (!(speed > 1e-12 * edge.norm())) continue;
                const double t = std::max(0.0, (p - at(mesh_.from(k))).dot(inward)) / speed;
                if (t >= way) continue;
                way = t;
                out = k;
            }
            if (!out.is_valid() || way >= left || mesh_.is_constrained(M::edge(out))) return normal;
            left -= way;
            p += way * direction;
            along = (at(mesh_.to(out)) - at(mesh_.from(out))).normalized();
            const double forward = direction.dot(along);
            const double across = std::sqrt(std::max(0.0, 1.0 - forward * forward));
            h = M::twin(out);
            const Vector3d next = doubled_area_vector(mesh_, mesh_.face(h));
            if (!(next.norm() > 0.0)) return normal;
            normal = next.normalized();
            // On this side the edge runs the other way: inward is normal × (−along).
            direction = forward * along - across * normal.cross(along);
        }
        return normal;
    }

    void grow(Edge seed) {
        const HalfEdge h = M::halfedge(seed);
        if (is_used(mesh_.from(h)) || is_used(mesh_.to(h))) return;
        std::vector<HalfEdge> ahead{h};
        extend(ahead);
        std::vector<HalfEdge> back{M::twin(h)};
        if (mesh_.to(ahead.back()) != mesh_.from(h)) extend(back);
        for (auto* chain : {&ahead, &back}) {
            if (chain->size() > 1 && meets_sharply(chain->back())) chain->pop_back();
        }
        double length = mesh_.length(seed);
        for (std::size_t i = 1; i < ahead.size(); ++i) length += mesh_.length(ahead[i]);
        for (std::size_t i = 1; i < back.size(); ++i) length += mesh_.length(back[i]);
        if (length < kLeastLength * options_.width) return;
        keep(ahead, 0);
        keep(back, 1);
        for (const auto* chain : {&ahead, &back}) {
            for (const HalfEdge k : *chain) shut(k);
        }
    }

    void keep(const std::vector<HalfEdge>& chain, std::size_t first) {
        for (std::size_t i = first; i < chain.size(); ++i) {
            ridges_.edges.push_back({mesh_.from(chain[i]).index(), mesh_.to(chain[i]).index()});
            is_ridge_[static_cast<std::size_t>(M::edge(chain[i]).index())] = 1;
        }
    }

    /// True if an edge runs into another line or ridge at so small an angle that no quad fits between them.
    bool meets_sharply(HalfEdge last) const {
        const Vertex v = mesh_.to(last);
        const Vector3d back = (at(mesh_.from(last)) - at(v)).normalized();
        for (const HalfEdge out : mesh_.outgoing(v)) {
            const Edge e = M::edge(out);
            if (!mesh_.is_constrained(e) && is_ridge_[static_cast<std::size_t>(e.index())] == 0) continue;
            if (back.dot((at(mesh_.to(out)) - at(v)).normalized()) > kSharpMeeting) return true;
        }
        return false;
    }

    bool is_on_line(Vertex v) const {
        for (const HalfEdge out : mesh_.outgoing(v)) {
            if (mesh_.is_constrained(M::edge(out))) return true;
        }
        return false;
    }

    void extend(std::vector<HalfEdge>& chain) {
        const Vertex start = mesh_.from(chain.front());
        const double turn = fold(M::edge(chain.front())).turn;
        for (std::int32_t guard = 0; guard < mesh_.edge_slots(); ++guard) {
            const HalfEdge last = chain.back();
            const Vertex v = mesh_.to(last);
            if (v == start || is_used(v) || is_on_line(v)) return;
            const Vector3d along = (at(v) - at(mesh_.from(last))).normalized();
            HalfEdge best;
            double best_cost = kImbalance;
            for (const HalfEdge out : mesh_.outgoing(v)) {
                const Fold& f = fold(M::edge(out));
                if (!f.is_candidate || out == M::twin(last)) continue;
                const double cosine = along.dot((at(mesh_.to(out)) - at(v)).normalized());
                if (cosine < kStraight) continue;
                // Along the fold the surface turns most; edges across it may look as balanced, but turn less.
                const double cost = f.imbalance + 0.5 * (1.0 - cosine) + 0.5 * std::max(0.0, 1.0 - f.turn / turn);
                if (cost >= best_cost || runs_into(chain, mesh_.to(out))) continue;
                best_cost = cost;
                best = out;
            }
            if (!best.is_valid()) return;
            chain.push_back(best);
        }
    }

    /// The chain would meet itself elsewhere than at its start.
    bool runs_into(const std::vector<HalfEdge>& chain, Vertex v) const {
        return std::any_of(chain.begin() + 1, chain.end(), [&](HalfEdge h) { return mesh_.from(h) == v; });
    }

    /// Marks the vertices within the width of a line's edge, so that no other ridge begins there, and the fold's edges.
    void shut(HalfEdge h) {
        std::vector<Vertex> queue{mesh_.from(h), mesh_.to(h)};
        ++now_;
        const auto reach = [&](Vertex v) {
            std::int32_t& stamp = reached_[static_cast<std::size_t>(v.index())];
            if (stamp == now_) return false;
            stamp = now_;
            used_[static_cast<std::size_t>(v.index())] = 1;
            return true;
        };
        for (const Vertex v : queue) reach(v);
        const Point a = at(mesh_.from(h));
        const Vector3d edge = at(mesh_.to(h)) - a;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (const HalfEdge out : mesh_.outgoing(queue[i])) {
                const Vertex w = mesh_.to(out);
                const double t = std::clamp((at(w) - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
                if ((a + t * edge - at(w)).norm() > options_.width) continue;
                if (fold(M::edge(out)).is_candidate) ridges_.in_fold[static_cast<std::size_t>(M::edge(out).index())] = 1;
                if (reach(w)) queue.push_back(w);
            }
        }
    }

    const SurfaceMesh& mesh_;
    std::span<const char> patches_;
    const RidgeOptions& options_;
    std::vector<Fold> folds_;
    std::vector<char> used_;             ///< per vertex: on a ridge or so close to one that no other begins or goes on there
    std::vector<std::int32_t> reached_;  ///< per vertex: last edge whose surroundings it was found in
    std::int32_t now_ = 0;
    std::vector<char> is_ridge_;  ///< per edge
    Ridges ridges_;
};

}  // namespace

Ridges find_ridges(const SurfaceMesh& mesh, std::span<const char> patches, const RidgeOptions& options) {
    return RidgeFinder(mesh, patches, options).run();
}

}  // namespace anisoquad
