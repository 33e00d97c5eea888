#include "smoothing/move_node.h"

#include <algorithm>
#include <optional>

#include "smoothing/flat_star.h"
#include "smoothing/star.h"
#include "surface/surface_fit.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr int kTries = 4;
constexpr double kAtRest = 0.01;  ///< steps below this over the length of an edge change nothing
/// Nodes are often put on a straight edge, where the worst element is 0: rounding must not choose its sign.
constexpr double kUpright = 1e-9;

/// A move passes if it inverts nothing and the worst element stays above the lower of its old quality and what is good enough.
/// @param before worst element before the move, asked for only where it matters
template <class Before>
bool is_good(double worst, const Before& before, double good_enough) {
    return worst > kUpright && (worst >= good_enough || worst >= before());
}

void put(SurfaceMesh& mesh, Vertex v, const Point& p, std::int32_t facet, std::int32_t* hint) {
    mesh.position(v) = p;
    mesh.info(v).input = -1;
    if (hint) *hint = facet;
}

/// Where the surface hardly turns, its tangent plane stands for it.
/// @returns whether the node was moved; nothing where a face is turned over before, which Star::tangle() may mend
std::optional<bool> move_in_plane(SurfaceMesh& mesh, Vertex v, const FlatStar& star, const Point& target,
                                  const ReferenceSurface& reference, std::int32_t* hint, double good_enough) {
    std::optional<double> worst;
    const auto before = [&] { return worst ? *worst : *(worst = star.quality(star.centre()).worst); };
    std::int32_t facet = hint ? *hint : -1;
    Eigen::Vector2d step = star.coordinates(target);
    for (int i = 0; i <= kTries; ++i, step *= 0.5) {
        const Point p = reference.project(star(step), {star.patch(), star.normal()}, facet);
        if (p == star.centre()) return false;
        if (!p.allFinite()) continue;
        if (!is_good(star.quality(p).worst, before, good_enough)) {
            if (before() <= kUpright) return std::nullopt;
            continue;
        }
        put(mesh, v, p, facet, hint);
        return true;
    }
    return false;
}

/// @param reference may be null: the polynomial round the node stands for the surface
bool move_in_space(SurfaceMesh& mesh, Vertex v, const Point& target, const ReferenceSurface* reference, std::int32_t* hint,
                   double good_enough) {
    Star star;
    if (!star.gather(mesh, v)) return false;
    if (reference) star.see_along_surface(*reference, hint ? *hint : -1);
    std::optional<double> worst;
    const auto before = [&] { return worst ? *worst : *(worst = star.quality(star.centre()).worst); };
    const auto is_acceptable = [&](const Point& p) {
        const double now = star.quality(p).worst;
        return is_good(now, before, good_enough) ||
               (now <= kUpright && before() <= kUpright && star.tangle(p) < star.tangle(star.centre()));
    };
    // The exponential map of a folded ring is no map of the surface.
    SurfaceFit fit;
    const bool fitted = !(reference && star.is_flat()) && before() > kUpright && !star.is_on_fold() && fit_surface(mesh, v, fit);
    Vector3d step = target - star.centre();
    if (star.is_on_fold()) step = star.along_fold(step);
    std::int32_t facet = hint ? *hint : -1;
    for (int i = 0; i <= kTries; ++i, step *= 0.5) {
        const Point wanted = star.centre() + step;
        Point p = fitted ? point_at_target(fit, wanted) : Point(wanted - step.dot(star.normal()) * star.normal());
        if (reference) p = reference->project(p, {star.patch(), star.normal()}, facet);
        if (p == star.centre()) return false;
        if (!p.allFinite() || !is_acceptable(p)) continue;
        if (reference && !star.stays_near(*reference, p) && before() > kUpright) continue;
        put(mesh, v, p, facet, hint);
        return true;
    }
    return false;
}

}  // namespace

bool is_movable(const SurfaceMesh& mesh, Vertex v) {
    const VertexInfo& info = mesh.info(v);
    return info.kind == NodeKind::interior && !info.in_row && !mesh.is_boundary(v);
}

Vector3d node_normal(const SurfaceMesh& mesh, Vertex v) {
    Star star;
    return star.gather(mesh, v) ? star.normal() : Vector3d::Zero();
}

double worst_quality(const SurfaceMesh& mesh, Vertex v, const Vector3d& normal) {
    Star star;
    if (!star.gather(mesh, v)) return 0.0;
    star.see_along(normal);
    return star.quality(star.centre()).worst;
}

bool move_node(SurfaceMesh& mesh, Vertex v, const Point& target, const ReferenceSurface* reference, std::int32_t* hint,
               double good_enough) {
    if (!is_movable(mesh, v)) return false;
    if ((target - mesh.position(v)).norm() < kAtRest * mesh.length(mesh.halfedge(v))) return false;
    FlatStar flat;
    if (reference && flat.gather(mesh, v)) {
        const std::optional<bool> moved = move_in_plane(mesh, v, flat, target, *reference, hint, good_enough);
        if (moved) return *moved;
    }
    return move_in_space(mesh, v, target, reference, hint, good_enough);
}

}  // namespace anisoquad
