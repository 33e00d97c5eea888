#include "picking/onto_surface.h"

#include <algorithm>
#include <limits>

#include "surface/reference_surface.h"

namespace anisoquad {
namespace {

Point onto_lines(const PickSurface& surface, const std::vector<HalfEdge>& edges, const Point& p) {
    Point best = p;
    double nearest = std::numeric_limits<double>::infinity();
    for (const HalfEdge h : edges) {
        const Point& a = surface.mesh.position(surface.mesh.from(h));
        const Eigen::Vector3d ab = surface.mesh.position(surface.mesh.to(h)) - a;
        const Point q = a + std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab;
        if ((q - p).squaredNorm() >= nearest) continue;
        nearest = (q - p).squaredNorm();
        best = q;
    }
    return best;
}

}  // namespace

std::vector<Point> onto_surface(const PickSurface& surface, std::span<const Point> points, std::span<const bool> on_line) {
    assert(points.size() == on_line.size());
    const ReferenceSurface reference(surface.points, surface.triangles);
    std::vector<HalfEdge> edges;
    for (std::int32_t e = 0; e < surface.mesh.edge_slots(); ++e) {
        if (surface.mesh.is_constrained(Edge(e))) edges.push_back(SurfaceMesh::halfedge(Edge(e)));
    }
    std::vector<Point> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::int32_t hint = -1;
        result.push_back(on_line[i] && !edges.empty() ? onto_lines(surface, edges, points[i])
                                                      : reference.project(points[i], ReferenceSurface::kAnyPatch, hint));
    }
    return result;
}

}  // namespace anisoquad
