#include "prepare/collapse_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "mesh/area_vector.h"
#include "mesh/euler_operators.h"
#include "prepare/remesh.h"
#include "prepare/triangle_shape.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kLeastShape = 0.1;    ///< of a triangle after a collapse, where the worst before was not poorer still
constexpr double kLongestEdge = 1.45;  ///< over the wanted edge
constexpr double kSliver = 0.1;        ///< shape below which a triangle's own normal is not looked at
constexpr double kLeastCosine = 0.3;   ///< between a triangle before and after the collapse, if it was no sliver

/// True where the triangle at h, which would go, is all that keeps two lines apart.
bool joins_lines(const SurfaceMesh& mesh, HalfEdge h) {
    return !mesh.is_boundary(h) && mesh.is_constrained(M::edge(mesh.next(h))) && mesh.is_constrained(M::edge(mesh.prev(h)));
}

/// The middles of the new edges and triangles, against the surface of their patch.
bool stays_on_surface(const SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface& reference, double deviation) {
    const Vertex gone = mesh.from(h);
    const Vertex kept = mesh.to(h);
    const Point& place = mesh.position(kept);
    std::int32_t hint = -1;
    for (const HalfEdge out : mesh.outgoing(gone)) {
        if (mesh.is_boundary(out)) continue;
        const Vertex a = mesh.to(out);
        const Vertex b = mesh.to(mesh.next(out));
        if (a == kept || b == kept) continue;
        const std::int32_t patch = mesh.info(mesh.face(out)).patch;
        const Point& p = mesh.position(a);
        const Point& q = mesh.position(b);
        const SurfacePoint middle = reference.closest((place + p + q) / 3.0, patch, hint);
        hint = middle.facet;
        if (middle.distance > deviation || reference.closest(0.5 * (place + p), patch, hint).distance > deviation) return false;
        if (!(doubled_area_vector(place, p, q).dot(middle.normal) > 0.0)) return false;
    }
    return true;
}

}  // namespace

bool may_collapse(const SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface& reference, double deviation) {
    if (!is_collapse_ok(mesh, h) || joins_lines(mesh, h) || joins_lines(mesh, M::twin(h))) return false;
    const Vertex gone = mesh.from(h);
    const Vertex kept = mesh.to(h);
    const Point& old = mesh.position(gone);
    const Point& place = mesh.position(kept);
    double worst = 1.0;
    Vector3d normal = Vector3d::Zero();
    for (const HalfEdge out : mesh.outgoing(gone)) {
        if (mesh.is_boundary(out)) continue;
        normal += doubled_area_vector(old, mesh.position(mesh.to(out)), mesh.position(mesh.to(mesh.next(out))));
        worst = std::min(worst, triangle_shape(old, mesh.position(mesh.to(out)), mesh.position(mesh.to(mesh.next(out)))));
    }
    for (const HalfEdge out : mesh.outgoing(gone)) {
        const Vertex a = mesh.to(out);
        const Point& p = mesh.position(a);
        const double length = (p - place).norm();
        const double wanted = kTriangleEdge * 0.5 * (mesh.info(a).size + mesh.info(kept).size);
        if (a != kept && length > kLongestEdge * wanted && length > mesh.length(out)) return false;
        if (mesh.is_boundary(out)) continue;
        const Vertex b = mesh.to(mesh.next(out));
        if (a == kept || b == kept) continue;
        const Point& q = mesh.position(b);
        const double shape = triangle_shape(place, p, q);
        if (shape < std::min(kLeastShape, worst)) return false;
        const Vector3d before = doubled_area_vector(old, p, q);
        const Vector3d after = doubled_area_vector(place, p, q);
        // Slivers do not tell which way the surface faces.
        const bool is_sliver = triangle_shape(old, p, q) < kSliver;
        if (is_sliver ? !(after.dot(normal) > 0.0) : !(after.dot(before) > kLeastCosine * after.norm() * before.norm()))
            return false;
    }
    return stays_on_surface(mesh, h, reference, deviation);
}

bool try_collapse(SurfaceMesh& mesh, HalfEdge h, const ReferenceSurface& reference, double deviation, Coverage* coverage) {
    if (!may_collapse(mesh, h, reference, deviation)) return false;
    if (!coverage) {
        collapse(mesh, h);
        return true;
    }
    const Vertex gone = mesh.from(h);
    const Vertex kept = mesh.to(h);
    static thread_local std::vector<Coverage::Triangle> after;
    after.clear();
    for (const Vertex v : {gone, kept}) {
        for (const HalfEdge out : mesh.outgoing(v)) {
            if (mesh.is_boundary(out)) continue;
            const Vertex a = mesh.to(out);
            const Vertex b = mesh.to(mesh.next(out));
            if (a == gone || b == gone || a == kept || b == kept) continue;
            after.push_back({mesh.position(kept), mesh.position(a), mesh.position(b)});
        }
    }
    coverage->lift(mesh, gone);
    if (!coverage->is_covered_by(after)) {
        coverage->drop(mesh, gone);
        return false;
    }
    collapse(mesh, h);
    coverage->drop(mesh, kept);
    return true;
}

Vertex split_covered_edge(SurfaceMesh& mesh, Edge e, const Point& p, Coverage* coverage) {
    if (coverage) coverage->lift(mesh, e);
    const Vertex v = split_edge(mesh, e, p);
    if (coverage) coverage->drop(mesh, v);
    return v;
}

}  // namespace anisoquad
