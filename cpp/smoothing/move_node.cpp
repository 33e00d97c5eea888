#include "smoothing/move_node.h"

#include <algorithm>
#include <optional>

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
bool is_acceptable(const Star& star, const Before& before, const Point& p, double good_enough) {
    const double worst = star.quality(p).worst;
    if (worst > kUpright) return worst >= good_enough || worst >= before();
    return before() <= kUpright && star.tangle(p) < star.tangle(star.centre());
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
    Star star;
    if (!is_movable(mesh, v)) return false;
    if ((target - mesh.position(v)).norm() < kAtRest * mesh.length(mesh.halfedge(v)) || !star.gather(mesh, v)) return false;
    if (reference) star.see_along_surface(*reference, hint ? *hint : -1);
    std::optional<double> worst;
    const auto before = [&] { return worst ? *worst : *(worst = star.quality(star.centre()).worst); };
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
        if (!p.allFinite() || !is_acceptable(star, before, p, good_enough)) continue;
        if (reference && !star.stays_near(*reference, p) && before() > kUpright) continue;
        mesh.position(v) = p;
        mesh.info(v).input = -1;
        if (hint) *hint = facet;
        return true;
    }
    return false;
}

}  // namespace anisoquad
