#include "prepare/coverage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/area_vector.h"
#include "surface/closest_on_triangle.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kCurved = 0.02;  ///< sine of the turn at an edge that needs points of its own
constexpr int kMostOfEdge = 64;

Coverage::Triangle corners(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    return {mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.to(mesh.next(h)))};
}

Vector3d unit_normal(const SurfaceMesh& mesh, Face f) { return doubled_area_vector(mesh, f).normalized(); }

double distance2(const Point& p, const Coverage::Triangle& t) {
    return (closest_on_triangle(p, t[0], t[1], t[2]) - p).squaredNorm();
}

}  // namespace

Coverage::Coverage(const SurfaceMesh& mesh, double spacing, double bound)
    : bound2_(bound * bound), first_(static_cast<std::size_t>(mesh.face_slots()), -1) {
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !mesh.halfedge(v).is_valid()) continue;
        const HalfEdge h = mesh.halfedge(v);
        add(mesh.position(v), mesh.is_boundary(h) ? mesh.face(M::twin(h)) : mesh.face(h));
    }
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        const Edge e(i);
        if (mesh.is_deleted(e) || mesh.is_constrained(e)) continue;
        const HalfEdge h = M::halfedge(e);
        if (unit_normal(mesh, mesh.face(h)).cross(unit_normal(mesh, mesh.face(M::twin(h)))).norm() < kCurved) continue;
        const int parts = std::min(kMostOfEdge, static_cast<int>(std::ceil(mesh.length(e) / spacing)));
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            add((1.0 - t) * mesh.position(mesh.from(h)) + t * mesh.position(mesh.to(h)), mesh.face(h));
        }
    }
}

void Coverage::add(const Point& p, Face f) {
    std::int32_t& first = first_[static_cast<std::size_t>(f.index())];
    points_.push_back(p);
    next_.push_back(first);
    first = static_cast<std::int32_t>(points_.size()) - 1;
}

void Coverage::lift(const SurfaceMesh& mesh, Face f) {
    if (static_cast<std::size_t>(f.index()) >= first_.size()) return;
    const Triangle t = corners(mesh, f);
    std::int32_t& first = first_[static_cast<std::size_t>(f.index())];
    for (; first >= 0; first = next_[static_cast<std::size_t>(first)]) {
        lifted_.push_back(first);
        lifted_distance2_.push_back(distance2(points_[static_cast<std::size_t>(first)], t));
    }
}

void Coverage::lift(const SurfaceMesh& mesh, Vertex v) {
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_boundary(h)) lift(mesh, mesh.face(h));
    }
}

void Coverage::lift(const SurfaceMesh& mesh, Edge e) {
    for (const int side : {0, 1}) {
        if (mesh.face(M::halfedge(e, side)).is_valid()) lift(mesh, mesh.face(M::halfedge(e, side)));
    }
}

bool Coverage::is_covered_by(std::span<const Triangle> triangles) const {
    for (std::size_t i = 0; i < lifted_.size(); ++i) {
        const Point& p = points_[static_cast<std::size_t>(lifted_[i])];
        const double bound2 = std::max(bound2_, lifted_distance2_[i]);
        if (std::none_of(triangles.begin(), triangles.end(), [&](const Triangle& t) { return distance2(p, t) <= bound2; }))
            return false;
    }
    return true;
}

bool Coverage::is_covered_round(const SurfaceMesh& mesh, Vertex v) {
    triangles_.clear();
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_boundary(h))
            triangles_.push_back({mesh.position(v), mesh.position(mesh.to(h)), mesh.position(mesh.to(mesh.next(h)))});
    }
    return is_covered_by(triangles_);
}

void Coverage::drop(const SurfaceMesh& mesh, Vertex v) {
    faces_.clear();
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (!mesh.is_boundary(h)) faces_.push_back(mesh.face(h));
    }
    drop(mesh);
}

void Coverage::drop(const SurfaceMesh& mesh, Edge e) {
    faces_.clear();
    for (const int side : {0, 1}) {
        if (mesh.face(M::halfedge(e, side)).is_valid()) faces_.push_back(mesh.face(M::halfedge(e, side)));
    }
    drop(mesh);
}

void Coverage::drop(const SurfaceMesh& mesh) {
    if (first_.size() < static_cast<std::size_t>(mesh.face_slots()))
        first_.resize(static_cast<std::size_t>(mesh.face_slots()), -1);
    for (const std::int32_t i : lifted_) {
        Face closest;
        double least = 1e300;
        for (const Face f : faces_) {
            const double d = distance2(points_[static_cast<std::size_t>(i)], corners(mesh, f));
            if (d >= least) continue;
            least = d;
            closest = f;
        }
        if (!closest.is_valid()) continue;
        std::int32_t& first = first_[static_cast<std::size_t>(closest.index())];
        next_[static_cast<std::size_t>(i)] = first;
        first = i;
    }
    lifted_.clear();
    lifted_distance2_.clear();
}

}  // namespace anisoquad
