#include "picking/geodesic_path.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "picking/intrinsic_triangulation.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using T = IntrinsicTriangulation;
using Eigen::Vector2d;

constexpr double kStraight = std::numbers::pi - 1e-5;  ///< a joint with this angle on both sides is not bent
constexpr int kMostFlips = 1000000;

/// The triangles at a vertex from one half-edge, counter-clockwise, to another.
struct Wedge {
    HalfEdge first;
    HalfEdge last;
    double angle = 0.0;
};

/// @returns the wedge with its angle; infinite where the surface ends in between
Wedge wedge(const T& t, HalfEdge first, HalfEdge last) {
    Wedge w{first, last};
    for (HalfEdge h = first; h != last; h = T::twin(t.prev(h))) {
        if (!t.has_face(h)) return {first, last, std::numeric_limits<double>::infinity()};
        w.angle += t.angle(h);
    }
    return w;
}

/// Flips what stands inside the wedge until its outer side is straight or bends away. @returns that side, from to(first) to
/// to(last); nothing when the path itself is in the way, or there is no end
std::optional<std::vector<HalfEdge>> flip_out(T& t, const Wedge& w, const std::vector<HalfEdge>& path, int& flips) {
    const auto is_on_path = [&](HalfEdge h) {
        return std::any_of(path.begin(), path.end(), [&](HalfEdge p) { return p == h || p == T::twin(h); });
    };
    for (bool again = true; again;) {
        again = false;
        for (HalfEdge h = T::twin(t.prev(w.first)); h != w.last; h = T::twin(t.prev(h))) {
            if (t.angle(t.next(h)) + t.angle(T::twin(h)) >= std::numbers::pi - 1e-9) continue;
            if (is_on_path(h) || ++flips > kMostFlips) return std::nullopt;
            t.flip(h);
            again = true;
            break;
        }
    }
    std::vector<HalfEdge> arc;
    for (HalfEdge h = w.first; h != w.last; h = T::twin(t.prev(h))) arc.push_back(t.next(h));
    return arc;
}

/// Makes the path straight at all its joints.
bool straighten(T& t, std::vector<HalfEdge>& path) {
    int flips = 0;
    for (;;) {
        std::size_t joint = 0;
        Wedge sharpest;
        bool left = false;
        sharpest.angle = kStraight;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const Wedge on_left = wedge(t, path[i + 1], T::twin(path[i]));
            const Wedge on_right = wedge(t, T::twin(path[i]), path[i + 1]);
            const Wedge& w = on_left.angle < on_right.angle ? on_left : on_right;
            if (w.angle >= sharpest.angle) continue;
            sharpest = w;
            left = on_left.angle < on_right.angle;
            joint = i;
        }
        if (!sharpest.first.is_valid()) return true;
        std::optional<std::vector<HalfEdge>> arc = flip_out(t, sharpest, path, flips);
        if (!arc) return false;
        if (left) {  // the arc runs against the path
            std::reverse(arc->begin(), arc->end());
            for (HalfEdge& h : *arc) h = T::twin(h);
        }
        const auto at = path.begin() + static_cast<std::ptrdiff_t>(joint);
        path.insert(path.erase(at, at + 2), arc->begin(), arc->end());
    }
}

/// Third corner of a triangle over p → q, on the right of that direction.
Vector2d apex(const Vector2d& p, const Vector2d& q, double from_p, double from_q) {
    const double base = (q - p).norm();
    const Vector2d along = (q - p) / base;
    const double x = (from_p * from_p - from_q * from_q + base * base) / (2.0 * base);
    const double y = std::sqrt(std::max(from_p * from_p - x * x, 0.0));
    return p + x * along + y * Vector2d(along.y(), -along.x());
}

Crossing crossing_on(HalfEdge h, double t) { return {M::edge(h), h == M::halfedge(M::edge(h)) ? t : 1.0 - t}; }

/// Follows an edge of the intrinsic triangulation over the triangles of the mesh, unfolded so that it is the x axis.
std::optional<GeodesicPiece> trace(const SurfaceMesh& mesh, const T& original, const T& t, HalfEdge edge) {
    GeodesicPiece piece{t.from(edge), t.to(edge), {}};
    const double length = t.length(edge);
    const double total = original.total_angle(piece.from);
    double direction = t.direction(edge);
    if (!mesh.is_boundary(piece.from)) direction = std::fmod(std::fmod(direction, total) + total, total);
    HalfEdge start;
    for (const HalfEdge h : mesh.outgoing(piece.from)) {
        const double turn = direction - original.direction(h);
        const bool same_way = std::abs(turn) < 1e-7 || std::abs(std::abs(turn) - total) < 1e-7;
        if (mesh.to(h) == piece.to && same_way && std::abs(mesh.length(h) - length) < 1e-7 * length) return piece;
        if (original.has_face(h) && turn >= 0.0 && turn < original.angle(h)) start = h;
    }
    if (!start.is_valid()) return std::nullopt;
    const auto at = [](double radius, double angle) { return Vector2d(radius * std::cos(angle), radius * std::sin(angle)); };
    const double turn = original.direction(start) - direction;
    Vector2d below = at(mesh.length(start), turn);
    Vector2d above = at(mesh.length(mesh.prev(start)), turn + original.angle(start));
    HalfEdge exit = mesh.next(start);
    while (below.y() < 0.0 && above.y() > 0.0 && piece.crossings.size() < 100000) {
        const double s = below.y() / (below.y() - above.y());
        const HalfEdge entry = M::twin(exit);
        if ((1.0 - s) * below.x() + s * above.x() > length || mesh.is_boundary(entry)) return std::nullopt;
        piece.crossings.push_back(crossing_on(exit, s));
        const Vector2d third = apex(below, above, mesh.length(mesh.next(entry)), mesh.length(mesh.prev(entry)));
        if (mesh.to(mesh.next(entry)) == piece.to && (third - Vector2d(length, 0.0)).norm() < 1e-4 * length) return piece;
        exit = third.y() > 0.0 ? mesh.next(entry) : mesh.prev(entry);
        (third.y() > 0.0 ? above : below) = third;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::vector<GeodesicPiece>> geodesic_path(const SurfaceMesh& mesh, std::span<const Vertex> path) {
    std::vector<HalfEdge> edges;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) edges.push_back(mesh.find_halfedge(path[i], path[i + 1]));
    const T original(mesh);
    T t = original;
    if (!straighten(t, edges)) return std::nullopt;
    std::vector<GeodesicPiece> pieces;
    for (const HalfEdge h : edges) {
        std::optional<GeodesicPiece> piece = trace(mesh, original, t, h);
        if (!piece) return std::nullopt;
        pieces.push_back(std::move(*piece));
    }
    return pieces;
}

}  // namespace anisoquad
