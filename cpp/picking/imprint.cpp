#include "picking/imprint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "input/check.h"
#include "mesh/euler_operators.h"
#include "picking/geodesic_path.h"
#include "picking/zigzag.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kTolerance = 2.5;  ///< mean edges: how far a straight stretch may be from the path; on a ridge a third of it
constexpr double kSnap = 0.05;      ///< mean edges: a node so near to the straight line is on it
constexpr double kShort = 0.6;      ///< mean edges: nodes on the path that follow nearer are merged
constexpr double kNear = 0.4;       ///< mean edges: nodes beside the path that are nearer are merged into it
constexpr double kLong = 1.6;       ///< mean edges: longer edges of the path are halved
constexpr double kSameSide = 0.5;   ///< cosine: how far a triangle may turn when a node beside it goes
constexpr double kFlat = 0.94;      ///< cosine: two triangles that may exchange their diagonal
constexpr std::int32_t kPathLine = std::numeric_limits<std::int32_t>::max();

Vector3d doubled_area(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    const Point& a = mesh.position(mesh.from(h));
    return (mesh.position(mesh.to(h)) - a).cross(mesh.position(mesh.to(mesh.next(h))) - a);
}

/// The work on one path.
class Imprinter {
  public:
    Imprinter(const PickSurface& surface, std::span<const std::int32_t> path) : surface_(surface), mesh_(surface.mesh) {
        for (const std::int32_t v : path) path_.emplace_back(v);
        keep_ids();
        ridge_.assign(path.size(), 0.0);
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            spacing_ += mesh_.length(edge(i)) / static_cast<double>(path.size() - 1);
            const double curvature = std::max(surface.curvature[static_cast<std::size_t>(edge(i).index())], 0.0);
            const double ridge = curvature / (curvature + 4.0 * surface.mean_curvature);
            ridge_[i] = std::max(ridge_[i], ridge);
            ridge_[i + 1] = ridge;
        }
    }

    ImprintResult run() {
        if (is_zigzag(mesh_, path_)) {
            for (std::size_t i = 0; i + 1 < path_.size(); ++i) was_constrained_.push_back(mesh_.is_constrained(edge(i)));
            for (std::size_t i = 0; i + 1 < path_.size(); ++i) constrain(path_[i], path_[i + 1]);
            result_path_ = {path_.front()};
            for (std::size_t first = 0; first + 1 < path_.size();) {
                std::size_t last = first + 1;
                while (!was_constrained_[first] && last + 1 < path_.size() && !is_anchor(path_[last]) && !is_half_way(last))
                    ++last;
                straighten(first, last);
                first = last;
            }
            if (result_.pieces > 0 && is_connected()) improve();
            if (!is_connected()) take_back();
        } else {
            result_path_ = path_;
        }
        write();
        return std::move(result_);
    }

  private:
    Edge edge(std::size_t i) const { return M::edge(mesh_.find_halfedge(path_[i], path_[i + 1])); }
    void constrain(Vertex a, Vertex b) {
        EdgeInfo& info = mesh_.info(M::edge(mesh_.find_halfedge(a, b)));
        if (info.line < 0) info.line = kPathLine;
    }
    /// A closed path has to be held in two places.
    bool is_half_way(std::size_t i) const { return path_.front() == path_.back() && i == path_.size() / 2; }
    bool is_anchor(Vertex v) const { return surface_.mesh.info(v).line >= 0; }

    /// The stretch of the path between two of its nodes: straight if that is near enough, else in two parts.
    void straighten(std::size_t first, std::size_t last) {
        const std::span<const Vertex> stretch(path_.data() + first, last - first + 1);
        if (stretch.size() > 2 && is_zigzag(mesh_, stretch)) {
            const auto pieces = geodesic_path(mesh_, stretch);
            const auto [far, distance] =
                pieces ? farthest(first, stretch, *pieces) : std::pair(stretch.size() / 2, spacing_ * kTolerance * 2.0);
            if (distance > kTolerance * spacing_) {
                straighten(first, first + far);
                straighten(first + far, last);
                return;
            }
            for (std::size_t i = first; i < last; ++i) mesh_.info(edge(i)).line = -1;
            if (can_insert(*pieces)) {
                insert(*pieces);
                ++result_.pieces;
                return;
            }
            for (std::size_t i = first; i < last; ++i) mesh_.info(edge(i)).line = kPathLine;
        }
        result_path_.insert(result_path_.end(), stretch.begin() + 1, stretch.end());
    }

    Point at(const Crossing& crossing) const {
        const HalfEdge h = M::halfedge(crossing.edge);
        return (1.0 - crossing.t) * mesh_.position(mesh_.from(h)) + crossing.t * mesh_.position(mesh_.to(h));
    }

    /// The node of the stretch that begins with path_[first] that is farthest from the pieces, and how far it is.
    std::pair<std::size_t, double> farthest(std::size_t first, std::span<const Vertex> stretch,
                                            const std::vector<GeodesicPiece>& pieces) const {
        std::vector<Point> line{mesh_.position(pieces.front().from)};
        for (const GeodesicPiece& piece : pieces) {
            for (const Crossing& crossing : piece.crossings) line.push_back(at(crossing));
            line.push_back(mesh_.position(piece.to));
        }
        std::pair<std::size_t, double> result{stretch.size() / 2, 0.0};
        for (std::size_t i = 1; i + 1 < stretch.size(); ++i) {
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k + 1 < line.size(); ++k)
                nearest = std::min(nearest, distance_to_segment(mesh_.position(stretch[i]), line[k], line[k + 1]));
            nearest *= 1.0 + 2.0 * ridge_[first + i];
            if (nearest > result.second) result = {i, nearest};
        }
        return result;
    }

    static double distance_to_segment(const Point& p, const Point& a, const Point& b) {
        const Vector3d ab = b - a;
        const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), std::numeric_limits<double>::min()), 0.0, 1.0);
        return (a + t * ab - p).norm();
    }

    bool can_insert(const std::vector<GeodesicPiece>& pieces) const {
        std::vector<Edge> crossed;
        for (const GeodesicPiece& piece : pieces) {
            for (const Crossing& crossing : piece.crossings) crossed.push_back(crossing.edge);
        }
        std::sort(crossed.begin(), crossed.end());
        const bool twice = std::adjacent_find(crossed.begin(), crossed.end()) != crossed.end();
        return !twice && std::none_of(crossed.begin(), crossed.end(), [&](Edge e) { return mesh_.is_constrained(e); });
    }

    void insert(const std::vector<GeodesicPiece>& pieces) {
        for (const GeodesicPiece& piece : pieces) {
            for (const Crossing& crossing : piece.crossings) append(node_at(crossing));
            append(piece.to);
        }
    }

    void append(Vertex v) {
        if (v == result_path_.back()) return;
        if (mesh_.find_halfedge(result_path_.back(), v).is_valid()) constrain(result_path_.back(), v);
        result_path_.push_back(v);
    }

    /// A new node, or the edge's end that is nearly there.
    Vertex node_at(const Crossing& crossing) {
        const Point p = at(crossing);
        const HalfEdge h = M::halfedge(crossing.edge);
        const Vertex end = crossing.t < 0.5 ? mesh_.from(h) : mesh_.to(h);
        const bool is_near = (mesh_.position(end) - p).norm() < kSnap * spacing_;
        return is_near && (end == result_path_.back() || !touches_line(end)) ? end : new_node(crossing.edge, p);
    }

    bool touches_line(Vertex v) const {
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (mesh_.is_constrained(M::edge(h))) return true;
        }
        return false;
    }

    bool is_connected() const {
        for (std::size_t i = 0; i + 1 < result_path_.size(); ++i) {
            if (!mesh_.find_halfedge(result_path_[i], result_path_[i + 1]).is_valid()) return false;
        }
        return true;
    }

    /// What could not be done leaves everything as it was.
    void take_back() {
        mesh_ = surface_.mesh;
        keep_ids();
        result_path_ = path_;
        result_.pieces = 0;
    }

    void keep_ids() {
        id_.resize(surface_.points.size());
        std::iota(id_.begin(), id_.end(), 0);
    }

    Vertex new_node(Edge e, const Point& p) {
        const Vertex v = split_edge(mesh_, e, p);
        if (static_cast<std::size_t>(v.index()) >= id_.size()) id_.resize(static_cast<std::size_t>(v.index()) + 1, -1);
        id_[static_cast<std::size_t>(v.index())] = -1;
        return v;
    }

    bool is_new(Vertex v) const { return id_[static_cast<std::size_t>(v.index())] < 0; }

    /// A node that only this path needs.
    bool is_free(Vertex v) const { return is_new(v) || !is_anchor(v); }

    /// Nodes at even distances on the path, none too near beside it, well-shaped triangles.
    void improve() {
        for (std::size_t i = 1; i + 1 < result_path_.size();) {
            const double before = (mesh_.position(result_path_[i]) - mesh_.position(result_path_[i - 1])).norm();
            const double after = (mesh_.position(result_path_[i + 1]) - mesh_.position(result_path_[i])).norm();
            const Vertex target = before <= after ? result_path_[i - 1] : result_path_[i + 1];
            if (is_free(result_path_[i]) && std::min(before, after) < kShort * spacing_ && merge(result_path_[i], target)) {
                result_path_.erase(result_path_.begin() + static_cast<std::ptrdiff_t>(i));
                i = std::max<std::size_t>(i, 2) - 1;
            } else {
                ++i;
            }
        }
        for (std::size_t i = 0; i + 1 < result_path_.size(); ++i) {
            const Edge e = M::edge(mesh_.find_halfedge(result_path_[i], result_path_[i + 1]));
            if (mesh_.info(e).line != kPathLine || mesh_.length(e) < kLong * spacing_) continue;
            const Point middle = 0.5 * (mesh_.position(result_path_[i]) + mesh_.position(result_path_[i + 1]));
            result_path_.insert(result_path_.begin() + static_cast<std::ptrdiff_t>(i) + 1, new_node(e, middle));
        }
        flip_near();
        for (std::size_t i = 0; i + 1 < result_path_.size(); ++i) {
            while (merge_apex(result_path_[i], result_path_[i + 1]) || merge_apex(result_path_[i + 1], result_path_[i])) {
            }
        }
        flip_near();
    }

    /// Takes the node on the left of an edge of the path away when it is too near.
    bool merge_apex(Vertex a, Vertex b) {
        const HalfEdge h = mesh_.find_halfedge(a, b);
        if (mesh_.is_boundary(h) || mesh_.info(M::edge(h)).line != kPathLine) return false;
        const Vertex apex = mesh_.to(mesh_.next(h));
        const Point& p = mesh_.position(apex);
        if (distance_to_segment(p, mesh_.position(a), mesh_.position(b)) > kNear * spacing_) return false;
        if (touches_line(apex)) return false;
        const bool nearer_a = (p - mesh_.position(a)).norm() <= (p - mesh_.position(b)).norm();
        return merge(apex, nearer_a ? a : b) || merge(apex, nearer_a ? b : a);
    }

    /// Twice the area over the square of the longest edge: 0.87 for the best triangle.
    static double shape(const Point& a, const Point& b, const Point& c) {
        return (b - a).cross(c - a).norm() / std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    }

    /// Collapses v into target, unless that would turn a triangle over, or make one slimmer than the slimmest that was there.
    bool merge(Vertex v, Vertex target) {
        const HalfEdge h = mesh_.find_halfedge(v, target);
        if (!h.is_valid() || mesh_.is_boundary(v) || !is_collapse_ok(mesh_, h)) return false;
        const Point& p = mesh_.position(v);
        const Point& q = mesh_.position(target);
        double slimmest = 0.2;
        double slimmest_after = 1.0;
        for (const HalfEdge out : mesh_.outgoing(v)) {
            const Vertex b = mesh_.to(out);
            const Vertex c = mesh_.from(mesh_.prev(out));
            slimmest = std::min(slimmest, shape(p, mesh_.position(b), mesh_.position(c)));
            if (b == target || c == target) continue;
            slimmest_after = std::min(slimmest_after, shape(q, mesh_.position(b), mesh_.position(c)));
            const Vector3d after = (mesh_.position(b) - q).cross(mesh_.position(c) - q);
            if (after.dot(doubled_area(mesh_, mesh_.face(out)).normalized()) < kSameSide * after.norm()) return false;
        }
        if (slimmest_after < slimmest) return false;
        collapse(mesh_, h);
        return true;
    }

    /// Delaunay flips in the two rings of triangles round the path, where the surface is flat enough.
    void flip_near() {
        for (int sweep = 0; sweep < 10; ++sweep) {
            std::vector<Edge> edges;
            for (const Vertex v : result_path_) {
                for (const HalfEdge out : mesh_.outgoing(v)) {
                    for (const HalfEdge next : mesh_.outgoing(mesh_.to(out))) edges.push_back(M::edge(next));
                    if (!mesh_.is_boundary(out)) edges.push_back(M::edge(mesh_.next(out)));
                }
            }
            std::sort(edges.begin(), edges.end());
            edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
            bool changed = false;
            for (const Edge e : edges) changed = flip_if_better(e) || changed;
            if (!changed) return;
        }
    }

    double opposite_angle(HalfEdge h) const {
        const Point& p = mesh_.position(mesh_.to(mesh_.next(h)));
        const Vector3d a = mesh_.position(mesh_.from(h)) - p;
        const Vector3d b = mesh_.position(mesh_.to(h)) - p;
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }

    bool flip_if_better(Edge e) {
        if (!is_flip_ok(mesh_, e)) return false;
        const HalfEdge h = M::halfedge(e);
        const double sum = opposite_angle(h) + opposite_angle(M::twin(h));
        if (sum < std::numbers::pi + 1e-6) return false;
        const Vector3d left = doubled_area(mesh_, mesh_.face(h)).normalized();
        const Vector3d right = doubled_area(mesh_, mesh_.face(M::twin(h))).normalized();
        if (left.dot(right) < kFlat) return false;
        flip(mesh_, e);
        const Vector3d normal = left + right;
        if (doubled_area(mesh_, mesh_.face(h)).dot(normal) > 0.0 && doubled_area(mesh_, mesh_.face(M::twin(h))).dot(normal) > 0.0)
            return true;
        flip(mesh_, e);
        return false;
    }

    void write() {
        result_.points = surface_.points;
        for (std::int32_t v = 0; v < mesh_.vertex_slots(); ++v) {
            if (mesh_.is_deleted(Vertex(v)) || !is_new(Vertex(v))) continue;
            id_[static_cast<std::size_t>(v)] = static_cast<std::int32_t>(result_.points.size());
            result_.points.push_back(mesh_.position(Vertex(v)));
        }
        const auto id = [&](Vertex v) { return id_[static_cast<std::size_t>(v.index())]; };
        for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) {
            if (mesh_.is_deleted(Face(f))) continue;
            const HalfEdge h = mesh_.halfedge(Face(f));
            result_.triangles.push_back({id(mesh_.from(h)), id(mesh_.to(h)), id(mesh_.to(mesh_.next(h)))});
        }
        for (const Vertex v : result_path_) result_.path.push_back(id(v));
    }

    const PickSurface& surface_;
    SurfaceMesh mesh_;
    std::vector<Vertex> path_;
    std::vector<bool> was_constrained_;
    std::vector<double> ridge_;     ///< per node of the path: 0 on a flat or hollow place … 1 on a sharp ridge
    double spacing_ = 0.0;          ///< mean length of the path's edges
    std::vector<std::int32_t> id_;  ///< per vertex slot: its id in the result, -1 = new
    std::vector<Vertex> result_path_;
    ImprintResult result_;
};

void check_path(const PickSurface& surface, std::span<const std::int32_t> path) {
    const Source source{{path.begin(), path.end()}, {}, Sides::both};
    check_sources(surface.mesh, std::span(&source, 1));
}

}  // namespace

ImprintResult imprint(const PickSurface& surface, std::span<const std::int32_t> path) {
    check_path(surface, path);
    return Imprinter(surface, path).run();
}

}  // namespace anisoquad
