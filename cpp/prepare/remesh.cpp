#include "prepare/remesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/euler_operators.h"
#include "smoothing/laplacian.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

// Edge of the equilateral triangles whose pairs are as large as squares of the wanted size.
constexpr double kTriangleEdge = 1.0745699;
constexpr double kLong = 4.0 / 3.0;
constexpr double kShort = 4.0 / 5.0;
constexpr double kLeastTriangle = 0.1;  // scaled area of a triangle after a collapse

class Remesh {
  public:
    Remesh(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference) : mesh_(mesh), zone_(zone), reference_(reference) {}

    RemeshResult run(int iterations) {
        for (int i = 0; i < iterations; ++i) {
            const RemeshResult before = result_;
            collapse_short();
            split_long();
            result_.flips += swap_towards_delaunay(mesh_, zone_);
            relax();
            if (result_.splits == before.splits && result_.collapses == before.collapses && i > 0) break;
        }
        return result_;
    }

  private:
    const Point& at(Vertex v) const { return mesh_.position(v); }
    bool in_zone(Vertex v) const { return v.index() < static_cast<std::int32_t>(zone_.size()) && zone_[static_cast<std::size_t>(v.index())]; }
    double wanted(Edge e) const {
        const HalfEdge h = M::halfedge(e);
        return kTriangleEdge * 0.5 * (mesh_.info(mesh_.from(h)).size + mesh_.info(mesh_.to(h)).size);
    }

    /// An edge between two unmeshed triangles, both ends in the zone or one in it.
    bool is_candidate(Edge e) const {
        if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) return false;
        const HalfEdge h = M::halfedge(e);
        if (!in_zone(mesh_.from(h)) && !in_zone(mesh_.to(h))) return false;
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
        for (const auto& [ratio, e] : edges) {
            if (!is_candidate(e) || mesh_.length(e) >= kShort * wanted(e)) continue;
            const HalfEdge h = M::halfedge(e);
            if (try_collapse(h) || try_collapse(M::twin(h))) ++result_.collapses;
        }
    }

    bool try_collapse(HalfEdge h) {
        const Vertex gone = mesh_.from(h);
        const Vertex kept = mesh_.to(h);
        if (!is_free(gone) || !is_collapse_ok(mesh_, h)) return false;
        const Vector3d normal = node_normal(mesh_, gone);
        for (const HalfEdge out : mesh_.outgoing(gone)) {
            const Vertex p = mesh_.to(out);
            const Vertex q = mesh_.to(mesh_.next(out));
            if (p != kept) {
                const double size = kTriangleEdge * 0.5 * (mesh_.info(p).size + mesh_.info(kept).size);
                if ((at(p) - at(kept)).norm() > kLong * size * 1.2) return false;
            }
            if (p == kept || q == kept) continue;
            const Vector3d area = (at(p) - at(kept)).cross(at(q) - at(kept));
            const double edges = (at(p) - at(kept)).squaredNorm() + (at(q) - at(kept)).squaredNorm() + (at(p) - at(q)).squaredNorm();
            if (area.dot(normal) < kLeastTriangle * edges * 0.2886751) return false;
        }
        collapse(mesh_, h);
        return true;
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
        for (const auto& [ratio, e] : edges) {
            if (!is_candidate(e) || mesh_.length(e) <= kLong * wanted(e)) continue;
            const HalfEdge h = M::halfedge(e);
            const Vertex v = split_edge(mesh_, e, 0.5 * (at(mesh_.from(h)) + at(mesh_.to(h))));
            if (static_cast<std::size_t>(mesh_.vertex_slots()) > zone_.size()) zone_.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
            zone_[static_cast<std::size_t>(v.index())] = 1;
            std::int32_t hint = -1;
            const Point kept = at(v);
            mesh_.position(v) = reference_.project(kept, mesh_.info(mesh_.face(mesh_.halfedge(v))).patch, hint);
            if (worst_quality(mesh_, v, node_normal(mesh_, v)) <= 0.0) mesh_.position(v) = kept;
            ++result_.splits;
        }
    }

    void relax() {
        std::int32_t hint = -1;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || !is_free(v)) continue;
            Point target;
            if (laplacian_target(mesh_, v, target) && move_node(mesh_, v, target, &reference_, &hint)) ++result_.moves;
        }
    }

    SurfaceMesh& mesh_;
    std::vector<char>& zone_;
    const ReferenceSurface& reference_;
    RemeshResult result_;
};

/// Cosine and sine of the angle at r in the triangle p q r.
void opposite_angle(const Point& p, const Point& q, const Point& r, double& cosine, double& sine) {
    const Vector3d a = p - r;
    const Vector3d b = q - r;
    cosine = a.dot(b);
    sine = a.cross(b).norm();
}

}  // namespace

std::int32_t swap_towards_delaunay(SurfaceMesh& mesh, const std::vector<char>& zone) {
    std::int32_t flips = 0;
    const auto inside = [&](Vertex v) { return v.index() < static_cast<std::int32_t>(zone.size()) && zone[static_cast<std::size_t>(v.index())]; };
    for (int sweep = 0; sweep < 4; ++sweep) {
        const std::int32_t before = flips;
        for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
            const Edge e(i);
            if (mesh.is_deleted(e) || mesh.is_constrained(e)) continue;
            const HalfEdge h = M::halfedge(e);
            if (!inside(mesh.from(h)) && !inside(mesh.to(h))) continue;
            if (!is_flip_ok(mesh, e)) continue;
            const Point& p = mesh.position(mesh.from(h));
            const Point& q = mesh.position(mesh.to(h));
            const Point& l = mesh.position(mesh.to(mesh.next(h)));
            const Point& r = mesh.position(mesh.to(mesh.next(M::twin(h))));
            double cl = 0.0, sl = 0.0, cr = 0.0, sr = 0.0;
            opposite_angle(p, q, l, cl, sl);
            opposite_angle(p, q, r, cr, sr);
            // sin(angle sum) < 0: the sum is above π.
            const double scale = std::sqrt((cl * cl + sl * sl) * (cr * cr + sr * sr));
            if (sl * cr + cl * sr > -1e-6 * scale) continue;
            // The new triangles must face the same way as the old ones.
            const Vector3d n = (q - p).cross(l - p) + (r - p).cross(q - p);
            if ((r - p).cross(l - p).dot(n) <= 0.0 || (l - q).cross(r - q).dot(n) <= 0.0) continue;
            // Not over a crease that the triangles resolve: the swap may turn the surface a little only.
            const Vector3d a = (r - p).cross(l - p).normalized();
            const Vector3d b = (l - q).cross(r - q).normalized();
            const Vector3d c = (q - p).cross(l - p).normalized();
            const Vector3d d = (r - p).cross(q - p).normalized();
            if (a.dot(b) < std::min(0.8, c.dot(d) - 0.02)) continue;
            flip(mesh, e);
            ++flips;
        }
        if (flips == before) break;
    }
    return flips;
}

RemeshResult remesh_triangles(SurfaceMesh& mesh, std::vector<char>& zone, const ReferenceSurface& reference, int iterations) {
    return Remesh(mesh, zone, reference).run(iterations);
}

}  // namespace anisoquad
