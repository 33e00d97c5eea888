#include "prepare/size_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "mesh/arrays.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kLeastTurn = 1e-4;     ///< radians; less is rounding
constexpr double kSizeAtRidge = 0.6;    ///< least size at a ridge over the largest
constexpr double kOffRidge = 2.2;       ///< sagitta of elements beside a ridge over that of others
constexpr double kLengthOfWidth = 3.0;  ///< longest edges along a narrow place over its width

/// Height of the triangle of h over h.
double height(const SurfaceMesh& mesh, HalfEdge h) {
    const Vector3d along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
    const Vector3d offset = mesh.position(mesh.to(mesh.next(h))) - mesh.position(mesh.from(h));
    return (offset - offset.dot(along) * along).norm();
}

}  // namespace

SizeField::SizeField(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                     const ReferenceSurface& reference, const SizeFieldOptions& options)
    : reference_(reference), options_(options), facet_size_(triangles.size(), options.largest) {
    if (!options.vertex_size.empty()) {
        for (std::size_t f = 0; f < triangles.size(); ++f) {
            double sum = 0.0;
            for (const std::int32_t v : triangles[f]) sum += options.vertex_size[static_cast<std::size_t>(v)];
            facet_size_[f] = sum / 3.0;
        }
    }
    const SurfaceMesh mesh = from_arrays(points, triangles);
    if (options.curvature_angle > 0.0) limit_by_curvature(mesh);
    limit_by_width(mesh);
}

void SizeField::limit(std::int32_t facet, double size) {
    double& kept = facet_size_[static_cast<std::size_t>(facet)];
    kept = std::min(kept, std::max(size, options_.smallest));
}

double SizeField::coarsen_to(double triangles, std::span<const Point> points,
                             std::span<const std::array<std::int32_t, 3>> facets) {
    double wanted = 0.0;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto p = [&](std::size_t k) -> const Point& { return points[static_cast<std::size_t>(facets[f][k])]; };
        wanted += (p(1) - p(0)).cross(p(2) - p(0)).norm() / (facet_size_[f] * facet_size_[f]);
    }
    const double factor = std::sqrt(std::max(1.0, wanted / triangles));
    for (double& size : facet_size_) size *= factor;
    options_.largest *= factor;
    options_.smallest *= factor;
    return factor;
}

/// Elements beside a ridge span half the fold, which may lie off them by as much as coarse ones do; one that is thinner than that
/// is no matter of theirs.
double SizeField::size_at_ridge(double radius) const {
    const double most = kSizeAtRidge * options_.largest;
    const double off = kOffRidge * options_.sagitta;
    return radius < off ? most : std::min(most, std::sqrt(8.0 * radius * off));
}

void SizeField::limit_by_curvature(const SurfaceMesh& mesh) {
    const double angle = options_.curvature_angle * std::numbers::pi / 180.0;
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (mesh.is_boundary(Edge(e))) continue;
        const HalfEdge h = M::halfedge(Edge(e));
        const std::int32_t f = mesh.face(h).index();
        const std::int32_t g = mesh.face(M::twin(h)).index();
        // Across lines between patches the surface is not smooth: they turn by what they turn.
        if (reference_.facet_patch(f) != reference_.facet_patch(g)) continue;
        const Vector3d& a = reference_.facet_normal(f);
        const Vector3d& b = reference_.facet_normal(g);
        const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
        if (turn < kLeastTurn) continue;
        // The turn happens over half of either facet's height.
        const double radius = 0.5 * (height(mesh, h) + height(mesh, M::twin(h))) / turn;
        double size = std::min(angle * radius, std::sqrt(8.0 * radius * options_.sagitta));
        // A ridge line takes most of a fold's turn: the elements beside it are only a little smaller.
        const auto slot = static_cast<std::size_t>(e);
        if (slot < options_.in_fold.size() && options_.in_fold[slot]) size = std::max(size, size_at_ridge(radius));
        limit(f, size);
        limit(g, size);
    }
}

/// A facet with one edge on a line and the opposite corner on another one spans the way between them.
void SizeField::limit_by_width(const SurfaceMesh& mesh) {
    std::vector<char> on_line(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    const auto is_line = [&](HalfEdge h) {
        if (mesh.is_boundary(M::edge(h))) return true;
        return reference_.facet_patch(mesh.face(h).index()) != reference_.facet_patch(mesh.face(M::twin(h)).index());
    };
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        if (is_line(HalfEdge(i))) on_line[static_cast<std::size_t>(mesh.from(HalfEdge(i)).index())] = 1;
    }
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge h(i);
        if (mesh.is_boundary(h) || !is_line(h)) continue;
        const HalfEdge after = mesh.next(h);
        // At a corner between two lines the width means nothing.
        if (is_line(after) || is_line(mesh.next(after)) || !on_line[static_cast<std::size_t>(mesh.to(after).index())]) continue;
        limit(mesh.face(h).index(), kLengthOfWidth * height(mesh, h));
    }
}

double SizeField::size_at(const SurfaceMesh& mesh, Vertex v, std::int32_t& hint) const {
    // A node on a line touches several patches: the smallest size of them counts.
    double size = options_.vertex_size.empty() ? options_.largest : 1e300;
    std::int32_t before = -1;
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (mesh.is_boundary(h)) continue;
        const std::int32_t patch = mesh.info(mesh.face(h)).patch;
        if (std::exchange(before, patch) == patch) continue;
        const SurfacePoint closest = reference_.closest(mesh.position(v), patch, hint);
        if (closest.facet >= 0) {
            hint = closest.facet;
            size = std::min(size, facet_size_[static_cast<std::size_t>(hint)]);
        }
        if (mesh.info(v).kind == NodeKind::interior) break;
    }
    return size;
}

void SizeField::assign(SurfaceMesh& mesh, std::vector<std::int32_t>& hint, std::span<const char> kept,
                       std::span<const double> most, const Context& context) const {
    struct Bound {
        double size;
        Vertex v;
        bool operator<(const Bound& other) const { return size != other.size ? size > other.size : v > other.v; }
    };
    std::priority_queue<Bound> queue;
    hint.resize(static_cast<std::size_t>(mesh.vertex_slots()), -1);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        context.breathe_at(i);
        if (mesh.is_deleted(v) || !mesh.halfedge(v).is_valid()) continue;
        double size = size_at(mesh, v, hint[static_cast<std::size_t>(i)]);
        for (const HalfEdge h : mesh.outgoing(v)) {
            const auto e = static_cast<std::size_t>(M::edge(h).index());
            if (e < kept.size() && kept[e]) size = std::min(size, mesh.length(h));
        }
        const auto slot = static_cast<std::size_t>(i);
        if (slot < most.size() && most[slot] > 0.0) size = std::min(size, most[slot]);
        mesh.info(v).size = size;
        queue.push({size, v});
    }
    const double growth = options_.growth - 1.0;
    for (std::int64_t step = 0; !queue.empty(); ++step) {
        context.breathe_at(step);
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > mesh.info(v).size) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            const double allowed = size + growth * mesh.length(h);
            if (mesh.info(w).size <= allowed) continue;
            mesh.info(w).size = allowed;
            queue.push({allowed, w});
        }
    }
}

}  // namespace anisoquad
