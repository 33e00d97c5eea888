#include "input/needles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <unordered_map>
#include <vector>

#include "input/named_edges.h"
#include "mesh/area_vector.h"
#include "mesh/euler_operators.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kShort = 0.05;       ///< of an edge over the two others of its triangle
constexpr double kThin = 0.1;         ///< height over longest edge below which a triangle's own normal is not looked at
constexpr double kLeastCosine = 0.3;  ///< between a triangle before and after, if it was not thin
constexpr int kMostSharpEdges = 3;    ///< at the node that is left: two of a line, or those of a corner; two lines have four

bool is_thin(const Point& a, const Point& b, const Point& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return doubled_area_vector(a, b, c).norm() < kThin * longest;
}

/// True if the triangle on the left of h has two edges that are much longer.
bool is_short(const SurfaceMesh& mesh, HalfEdge h) {
    if (mesh.is_boundary(h)) return false;
    return mesh.length(h) < kShort * std::min(mesh.length(mesh.next(h)), mesh.length(mesh.prev(h)));
}

struct Needle {
    double length;
    Edge edge;

    bool operator<(const Needle& other) const {  // std::priority_queue takes the greatest first: the shortest
        return length != other.length ? length > other.length : edge > other.edge;
    }
};

class NeedleCollapse {
  public:
    NeedleCollapse(SurfaceMesh& mesh, double diagonal, std::span<const Source> sources, const Options& options)
        : mesh_(mesh),
          longest_(kNeedleLength * diagonal),
          sharp_(std::cos(options.feature_angle * std::numbers::pi / 180.0)),
          named_(sources, options) {}

    int run() {
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (!mesh_.is_deleted(Edge(i))) look_at(Edge(i));
        }
        int collapsed = 0;
        while (!waiting_.empty()) {
            const Needle needle = waiting_.top();
            waiting_.pop();
            if (mesh_.is_deleted(needle.edge) || mesh_.length(needle.edge) != needle.length) continue;
            const HalfEdge h = M::halfedge(needle.edge);
            const HalfEdge way = may_collapse(h) ? h : M::twin(h);
            if (way != h && !may_collapse(way)) continue;
            const Vertex kept = mesh_.to(way);
            const double reach = reach_of(mesh_.from(way)) + needle.length;
            collapse(mesh_, way);
            reach_[kept.index()] = std::max(reach_of(kept), reach);
            ++collapsed;
            for (const HalfEdge out : mesh_.outgoing(kept)) {
                look_at(M::edge(out));
                look_at(M::edge(mesh_.next(out)));
            }
        }
        return collapsed;
    }

  private:
    void look_at(Edge e) {
        const double length = mesh_.length(e);
        if (!(length < longest_)) return;
        const HalfEdge h = M::halfedge(e);
        if (is_short(mesh_, h) || is_short(mesh_, M::twin(h))) waiting_.push({length, e});
    }

    /// How far the farthest vertex that was merged into this one was from it.
    double reach_of(Vertex v) const {
        const auto found = reach_.find(v.index());
        return found == reach_.end() ? 0.0 : found->second;
    }

    bool may_collapse(HalfEdge h) const {
        const Vertex gone = mesh_.from(h);
        if (named_.touch(gone) || reach_of(gone) + mesh_.length(h) > longest_) return false;
        if (mesh_.is_boundary(gone) && !mesh_.is_boundary(M::edge(h))) return false;
        return is_collapse_ok(mesh_, h) && !is_beside_another(h) && !is_beside_another(M::twin(h)) && keeps_sides(h) &&
               sharp_edges_after(h) <= kMostSharpEdges;
    }

    /// True if the triangle beyond a long edge of the one on the left of h has a hair's edge, too.
    bool is_beside_another(HalfEdge h) const {
        if (mesh_.is_boundary(h)) return false;
        for (const HalfEdge g : {M::twin(mesh_.next(h)), M::twin(mesh_.prev(h))}) {
            if (!mesh_.is_boundary(g) && std::min(mesh_.length(mesh_.next(g)), mesh_.length(mesh_.prev(g))) < longest_)
                return true;
        }
        return false;
    }

    /// No triangle is turned over. Thin ones do not tell which way the surface faces: all at the node together do.
    bool keeps_sides(HalfEdge h) const {
        const Vertex kept = mesh_.to(h);
        const Point& old = mesh_.position(mesh_.from(h));
        const Point& place = mesh_.position(kept);
        Vector3d normal = Vector3d::Zero();
        for (const HalfEdge out : mesh_.outgoing(mesh_.from(h))) {
            if (!mesh_.is_boundary(out))
                normal += doubled_area_vector(old, mesh_.position(mesh_.to(out)), mesh_.position(mesh_.to(mesh_.next(out))));
        }
        for (const HalfEdge out : mesh_.outgoing(mesh_.from(h))) {
            if (mesh_.is_boundary(out) || mesh_.to(out) == kept || mesh_.to(mesh_.next(out)) == kept) continue;
            const Point& p = mesh_.position(mesh_.to(out));
            const Point& q = mesh_.position(mesh_.to(mesh_.next(out)));
            const Vector3d before = doubled_area_vector(old, p, q);
            const Vector3d after = doubled_area_vector(place, p, q);
            if (is_thin(old, p, q) ? !(after.dot(normal) > 0.0)
                                   : !(after.dot(before) > kLeastCosine * after.norm() * before.norm()))
                return false;
        }
        return true;
    }

    /// Edges at the node that is left that are sharp, named by the user, or of the boundary.
    int sharp_edges_after(HalfEdge h) const {
        struct Sector {
            Vector3d normal;  // zero for a gap
            bool named;       // its first edge, or one between it and the sector before
        };
        std::vector<Sector> sectors;  // that stay, counter-clockwise round the node
        bool named = false;
        for (const HalfEdge side : {h, M::twin(h)}) {
            for (HalfEdge out = mesh_.rotated_ccw(side); out != side; out = mesh_.rotated_ccw(out)) {
                named = named || named_.contains(mesh_, out);
                Vector3d normal = Vector3d::Zero();
                if (!mesh_.is_boundary(out)) {
                    if (mesh_.to(mesh_.next(out)) == mesh_.to(side)) continue;  // goes
                    normal = doubled_area_vector(mesh_.position(mesh_.to(h)), mesh_.position(mesh_.to(out)),
                                                 mesh_.position(mesh_.to(mesh_.next(out))))
                                 .normalized();
                }
                sectors.push_back({normal, named});
                named = false;
            }
        }
        int count = 0;
        for (std::size_t i = 0; i < sectors.size(); ++i) {
            const Sector& before = sectors[i == 0 ? sectors.size() - 1 : i - 1];
            const Sector& sector = sectors[i];
            const bool is_boundary = before.normal.isZero() || sector.normal.isZero();
            if (is_boundary || sector.named || (i == 0 && named) || before.normal.dot(sector.normal) < sharp_) ++count;
        }
        return count;
    }

    SurfaceMesh& mesh_;
    double longest_;
    double sharp_;  ///< cosine between triangles below which their edge is a feature
    NamedEdges named_;
    std::priority_queue<Needle> waiting_;
    std::unordered_map<std::int32_t, double> reach_;  ///< of the few vertices that others were merged into
};

}  // namespace

int collapse_needles(SurfaceMesh& mesh, double diagonal, std::span<const Source> sources, const Options& options) {
    return NeedleCollapse(mesh, diagonal, sources, options).run();
}

}  // namespace anisoquad
