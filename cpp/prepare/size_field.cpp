#include "prepare/size_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "mesh/arrays.h"

namespace anisoquad {

using M = SurfaceMesh;
using Eigen::Vector3d;

SizeField::SizeField(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                     const ReferenceSurface& reference, const SizeFieldOptions& options)
    : reference_(reference), options_(options), facet_size_(triangles.size(), options.largest) {
    const SurfaceMesh mesh = from_arrays(points, triangles);
    const double angle = options.curvature_angle * std::numbers::pi / 180.0;
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        const HalfEdge h = M::halfedge(Edge(e));
        const HalfEdge g = M::twin(h);
        if (mesh.is_boundary(Edge(e))) continue;
        const std::int32_t f = mesh.face(h).index();
        const std::int32_t k = mesh.face(g).index();
        // Across lines between patches the surface is not smooth: they turn by what they turn.
        if (reference.facet_patch(f) != reference.facet_patch(k)) continue;
        const Vector3d& a = reference.facet_normal(f);
        const Vector3d& b = reference.facet_normal(k);
        const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
        if (turn < 1e-4) continue;
        const Vector3d along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
        const auto height = [&](HalfEdge side) {
            const Vector3d offset = mesh.position(mesh.to(mesh.next(side))) - mesh.position(mesh.from(side));
            return (offset - offset.dot(along) * along).norm();
        };
        // The turn happens over half of either facet's height.
        const double allowed = std::clamp(0.5 * (height(h) + height(g)) * angle / turn, options.smallest, options.largest);
        for (const std::int32_t facet : {f, k}) {
            double& size = facet_size_[static_cast<std::size_t>(facet)];
            size = std::min(size, allowed);
        }
    }
}

void SizeField::assign(SurfaceMesh& mesh) const {
    struct Bound {
        double size;
        Vertex v;
        bool operator<(const Bound& other) const { return size != other.size ? size > other.size : v > other.v; }
    };
    std::priority_queue<Bound> queue;
    std::int32_t hint = -1;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !mesh.halfedge(v).is_valid()) continue;
        // A node on a line touches several patches: the smallest size of them counts.
        double size = options_.largest;
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (mesh.is_boundary(h)) continue;
            const SurfacePoint closest = reference_.closest(mesh.position(v), mesh.info(mesh.face(h)).patch, hint);
            hint = closest.facet;
            if (hint >= 0) size = std::min(size, facet_size_[static_cast<std::size_t>(hint)]);
            if (mesh.info(v).kind == NodeKind::interior) break;
        }
        // Short edges of lines are kept: what meets them has their size.
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (mesh.info(M::edge(h)).line >= 0) size = std::min(size, std::max(mesh.length(h), options_.smallest));
        }
        mesh.info(v).size = size;
        queue.push({size, v});
    }
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > mesh.info(v).size) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            const double allowed = size + options_.growth * mesh.length(h);
            if (mesh.info(w).size <= allowed) continue;
            mesh.info(w).size = allowed;
            queue.push({allowed, w});
        }
    }
}

}  // namespace anisoquad
