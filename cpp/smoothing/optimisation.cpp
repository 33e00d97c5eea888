#include "smoothing/optimisation.h"

#include <algorithm>
#include <cmath>

#include "smoothing/chart.h"
#include "smoothing/move_node.h"
#include "smoothing/pattern_search.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

constexpr double kFirstStep = 0.1;  ///< over the mean edge length
constexpr double kSmallestStep = 1e-3;
constexpr double kMeanWeight = 1e-2;   ///< of the mean beside the worst
constexpr double kLargestRatio = 6.0;  ///< of a quad's edges; an edge that shrinks to nothing could better the worst angle
constexpr double kLeastGain = 1e-6;

/// What is aimed at, and below any of its values how much a star is folded that has an inverted element.
double score(const Star& star, const Star::Quality& q, const Point& p, Aim aim) {
    if (q.worst <= 0.0) return -star.tangle(p);
    const double worst = aim == Aim::worst_element ? q.worst : std::max(q.worst, std::min(q.worst_changing, Star::kPoor));
    return std::sqrt(std::min(1.0, kLargestRatio / q.ratio)) * (worst + kMeanWeight * q.mean);
}

}  // namespace

bool optimise_node(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference, std::int32_t* hint, Aim aim) {
    Star star;
    if (!is_movable(mesh, v) || !star.gather(mesh, v)) return false;
    if (reference) star.see_along_surface(*reference, hint ? *hint : -1);
    const Chart chart(mesh, v, star);
    const Star::Quality old = star.quality(star.centre());
    const double before = score(star, old, star.centre(), aim);
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    const Eigen::Matrix2d axes =
        aim == Aim::worst_changing_corner ? chart.search_axes(mesh, v) : Eigen::Matrix2d(Eigen::Matrix2d::Identity());
    const auto score_at = [&](const Eigen::Vector2d& trial) {
        const Point p = chart(axes * trial);
        return score(star, star.quality(p), p, aim);
    };
    pattern_search(score_at, x, kFirstStep * star.edge_length(), kSmallestStep * star.edge_length());
    std::int32_t facet = hint ? *hint : -1;
    for (int i = 0; i < 3 && !x.isZero(0.0); ++i, x *= 0.5) {
        Point p = chart(axes * x);
        if (reference) p = reference->project(p, {star.patch(), star.normal()}, facet);
        if (!p.allFinite()) continue;
        const Star::Quality now = star.quality(p);
        if (score(star, now, p, aim) < before + kLeastGain) continue;
        if (aim == Aim::worst_changing_corner && before > 0.0 && now.worst < old.worst) continue;
        // Where the surface is thin, the side that a face is seen from can be the other one's: what looks turned over is not
        // mended by crossing what is not crossed.
        if (before <= 0.0 && star.crossed(p) > star.crossed(star.centre())) continue;
        // What is turned over is mended first.
        if (reference && before > 0.0 && !star.stays_near(*reference, p)) continue;
        mesh.position(v) = p;
        mesh.info(v).input = -1;
        if (hint) *hint = facet;
        return true;
    }
    return false;
}

}  // namespace anisoquad
