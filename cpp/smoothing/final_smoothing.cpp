#include "smoothing/final_smoothing.h"

#include <algorithm>
#include <vector>

#include "quality/metrics.h"
#include "smoothing/chart.h"
#include "smoothing/flat_star.h"
#include "smoothing/line_smoothing.h"
#include "smoothing/move_node.h"
#include "smoothing/optimisation.h"
#include "smoothing/pattern_search.h"
#include "smoothing/row_smoothing.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

constexpr double kFirstStep = 0.1;  ///< of the search for a node's place, over the mean edge length
constexpr double kSmallestStep = 0.01;
constexpr double kStepOfMove = 2.0;      ///< first step of the next search over the way that the last one led
constexpr double kLeastFirstStep = 0.02;
constexpr double kAtRest = 5e-3;     ///< moves below this, over the edge length, wake no neighbour
constexpr double kLeastGain = 1e-4;  ///< of the mean or the smallest scaled Jacobian, for another sweep
constexpr double kLeastScoreGain = 1e-6;
constexpr double kUpright = 1e-6;  ///< scaled Jacobian at which rounding no longer chooses the sign

struct Statistics {
    double min = 1.0;
    double mean = 1.0;
    int inverted = 0;
};

Statistics statistics(const SurfaceMesh& mesh) {
    Statistics s;
    double sum = 0.0;
    int quads = 0;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const Face f(i);
        if (mesh.is_deleted(f) || !mesh.is_quad(f)) continue;
        const double q = scaled_jacobian(mesh, f);
        s.min = std::min(s.min, q);
        s.inverted += q <= kUpright ? 1 : 0;
        sum += q;
        ++quads;
    }
    if (quads > 0) s.mean = sum / quads;
    return s;
}

class FinalSmoother {
  public:
    FinalSmoother(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines)
        : mesh_(mesh),
          reference_(reference),
          lines_(lines),
          hint_(static_cast<std::size_t>(mesh.vertex_slots()), -1),
          first_step_(static_cast<std::size_t>(mesh.vertex_slots()), static_cast<float>(kFirstStep)),
          awake_(static_cast<std::size_t>(mesh.vertex_slots()), 0) {}

    /// Visits, in the order of the slots, the nodes round which something moved in this sweep or the last one.
    /// @returns number of moves
    int sweep(int number) {
        int moves = 0;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || awake_[index(v)] + 1 < number) continue;
            const Point before = mesh_.position(v);
            const double edge = mesh_.length(mesh_.halfedge(v));
            if (!visit(v)) continue;
            ++moves;
            if ((mesh_.position(v) - before).norm() > kAtRest * edge) wake_neighbours(v, number);
        }
        return moves;
    }

  private:
    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.index()); }

    bool visit(Vertex v) {
        if (mesh_.info(v).kind != NodeKind::interior) {
            if (lines_.empty()) return slide_on_line(mesh_, v);
            if (reference_.target()) return slide_on_target(mesh_, v, lines_, reference_.target());
            return slide_on_line(mesh_, v) || slide_on_curve(mesh_, v, lines_);
        }
        Star star;
        if (!star.gather(mesh_, v)) return false;
        star.see_along_surface(reference_);
        const Star::Quality now = star.quality(star.centre());
        const double worst = now.worst;
        if (mesh_.info(v).in_row) return worst < Star::kPoor && slide_in_row(mesh_, v, &reference_, &hint_[index(v)]);
        if (!is_movable(mesh_, v)) return false;
        // An untangled star first; then the mean; then the worst, where the mean alone leaves a poor element.
        if (worst <= 0.0) return optimise_node(mesh_, v, &reference_, &hint_[index(v)]);
        const bool moved = relax(v, star, now);
        if (!moved && worst >= Star::kPoor) return false;
        if (moved && (!star.gather(mesh_, v) || star.quality(star.centre()).worst >= Star::kPoor)) return moved;
        return optimise_node(mesh_, v, &reference_, &hint_[index(v)]) || moved;
    }

    /// Moves the node to where its star scores best. A direct search gives a higher mean scaled Jacobian than any of the
    /// classical targets (0.942 on the swept wing; angle 0.927, Laplacian 0.923, isoparametric 0.891, best of them 0.933).
    bool relax(Vertex v, const Star& star, const Star::Quality& before) {
        if (star.is_flat() && star.has_quads_only()) {
            const FlatStar flat(star);
            return relax(v, star, before, [&](const Eigen::Vector2d& x) { return flat.score(x); }, [&](const Eigen::Vector2d& x) { return flat.at(x); });
        }
        const Chart chart(mesh_, v, star);
        return relax(v, star, before, [&](const Eigen::Vector2d& x) { return star.quality(chart(x)).score(); }, chart);
    }

    template <class Score, class Place>
    bool relax(Vertex v, const Star& star, const Star::Quality& before, const Score& score, const Place& place) {
        float& first_step = first_step_[index(v)];
        Eigen::Vector2d x = Eigen::Vector2d::Zero();
        pattern_search(score, x, static_cast<double>(first_step) * star.edge_length(), kSmallestStep * star.edge_length());
        first_step = static_cast<float>(std::clamp(kStepOfMove * x.norm() / star.edge_length(), kLeastFirstStep, kFirstStep));
        std::int32_t facet = hint_[index(v)];
        for (int i = 0; i < 3 && !x.isZero(0.0); ++i, x *= 0.5) {
            const Point p = reference_.project(place(x), star.patch(), facet);
            const Star::Quality after = star.quality(p);
            if (!(after.score() > before.score() + kLeastScoreGain)) continue;
            if (after.worst < before.worst && after.worst < Star::kPoor) continue;
            if (!star.stays_near(reference_, p)) continue;
            mesh_.position(v) = p;
            mesh_.info(v).input = -1;
            hint_[index(v)] = facet;
            return true;
        }
        return false;
    }

    void wake_neighbours(Vertex v, int number) {
        for (HalfEdge h : mesh_.outgoing(v)) {
            awake_[index(mesh_.to(h))] = number;
            if (mesh_.is_boundary(h)) continue;
            for (HalfEdge g : mesh_.halfedges(mesh_.face(h))) awake_[index(mesh_.from(g))] = number;
        }
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    const ReferenceLines& lines_;
    std::vector<std::int32_t> hint_;   ///< facet of the reference surface near each node
    std::vector<float> first_step_;    ///< of each node's next search, over the mean edge length
    std::vector<std::int32_t> awake_;  ///< last sweep in which something near the node moved
};

/// Nodes that were held for rows which then were given back are nodes like others.
void release_nodes_without_rows(SurfaceMesh& mesh) {
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !mesh.info(v).in_row || mesh.info(v).kind != NodeKind::interior) continue;
        bool in_row = false;
        for (HalfEdge h : mesh.outgoing(v)) in_row = in_row || (!mesh.is_boundary(h) && mesh.info(mesh.face(h)).row > 0);
        mesh.info(v).in_row = in_row;
    }
}

}  // namespace

FinalSmoothingResult smooth_mesh(SurfaceMesh& mesh, const ReferenceSurface& reference, const Options& options,
                                 Context& context, const ReferenceLines& lines) {
    FinalSmoothingResult result;
    Statistics last = statistics(mesh);
    result.min_before = last.min;
    result.mean_before = last.mean;
    release_nodes_without_rows(mesh);
    if (options.smoothing_passes > 0) result.moves += smooth_rows(mesh, &reference).moved;

    FinalSmoother smoother(mesh, reference, lines);
    while (result.sweeps < options.smoothing_passes) {
        context.report(static_cast<double>(result.sweeps) / options.smoothing_passes);
        const int moves = smoother.sweep(++result.sweeps);
        result.moves += moves;
        const Statistics now = statistics(mesh);
        const bool at_rest =
            now.min < last.min + kLeastGain && now.mean < last.mean + kLeastGain && now.inverted >= last.inverted;
        last = now;
        if (moves == 0 || at_rest) break;
    }
    result.min_after = last.min;
    result.mean_after = last.mean;
    result.inverted = last.inverted;
    return result;
}

}  // namespace anisoquad
