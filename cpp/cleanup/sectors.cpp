#include "cleanup/sectors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleanup/facing.h"
#include "mesh/face_middle.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using std::numbers::pi;

constexpr double kStraight = 0.85 * pi;  ///< a quad's corner above this is as good as none
constexpr int kStraightCost = 1;
constexpr float kNotKnown = -1.0F;  ///< angle of a sector of which the rest lies behind a cut

/// Corner of face(h) at from(h), −π/4…7π/4: slightly folded corners are negative, reflex ones above π.
double corner_angle(const SurfaceMesh& mesh, HalfEdge h, const Eigen::Vector3d& normal) {
    const Point& p = mesh.position(mesh.from(h));
    const Eigen::Vector3d first = mesh.position(mesh.to(h)) - p;
    const Eigen::Vector3d last = mesh.position(mesh.from(mesh.prev(h))) - p;
    const double angle = std::atan2(normal.dot(first.cross(last)), first.dot(last));
    return angle < -0.25 * pi ? angle + 2.0 * pi : angle;
}

/// @param hint facet near the face; receives the one below it
Eigen::Vector3d normal_at(const SurfaceMesh& mesh, Face f, const Eigen::Vector3d& up, const ReferenceSurface& reference,
                          std::int32_t& hint) {
    const SurfacePoint below = reference.closest(face_middle(mesh, f), {mesh.info(f).patch, up}, hint);
    hint = below.facet;
    return below.normal;
}

}  // namespace

Sectors::Sectors(const SurfaceMesh& mesh, const ReferenceSurface& reference)
    : angle_(static_cast<std::size_t>(mesh.halfedge_slots()), 0.0F) {
    std::int32_t hint = -1;
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge start(i);
        if (mesh.is_deleted(start) || mesh.is_boundary(start) || mesh.info(mesh.face(start)).row > 0) continue;
        if (!is_fixed(mesh, M::edge(start))) continue;
        const Eigen::Vector3d up = facing(mesh, start, [&](Edge e) { return is_fixed(mesh, e); });
        double angle = 0.0;
        bool at_cut = mesh.info(M::edge(start)).cut;
        HalfEdge h = start;
        do {
            angle += corner_angle(mesh, h, normal_at(mesh, mesh.face(h), up, reference, hint));
            h = mesh.rotated_ccw(h);
        } while (!is_fixed(mesh, M::edge(h)));
        at_cut = at_cut || mesh.info(M::edge(h)).cut;
        angle_[static_cast<std::size_t>(i)] = at_cut ? kNotKnown : static_cast<float>(std::max(angle, 1e-3));
    }
}

int Sectors::Count::cost() const {
    if (angle == 0.0F) return irregularity(quads);
    if (angle == kNotKnown) return 0;
    const int d = std::abs(quads - ideal);
    return d * (d + 1) / 2 + (angle / static_cast<float>(quads) > kStraight ? kStraightCost : 0);
}

Sectors::Count Sectors::count(const SurfaceMesh& mesh, HalfEdge h) const {
    Count result;
    HalfEdge start = h;
    while (!is_fixed(mesh, M::edge(start))) {
        start = mesh.rotated_cw(start);
        ++result.quads;
        if (start == h) return result;
    }
    result.angle = angle_[static_cast<std::size_t>(start.index())];
    result.ideal = std::max(1, static_cast<int>(std::lround(result.angle / (0.5 * pi))));
    result.quads = 0;
    h = start;
    do {
        ++result.quads;
        h = mesh.rotated_ccw(h);
    } while (!is_fixed(mesh, M::edge(h)));
    return result;
}

int Sectors::cost(const SurfaceMesh& mesh, Vertex v) const {
    int sum = 0;
    bool fixed = false;
    HalfEdge any;
    for (const HalfEdge h : mesh.outgoing(v)) {
        const bool outside = mesh.is_boundary(h) || mesh.info(mesh.face(h)).row > 0;
        if (!outside) any = h;
        if (!is_fixed(mesh, M::edge(h))) continue;
        fixed = true;
        if (!outside) sum += count(mesh, h).cost();
    }
    return fixed || !any.is_valid() ? sum : count(mesh, any).cost();
}

}  // namespace anisoquad
