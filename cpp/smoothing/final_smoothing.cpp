#include "smoothing/final_smoothing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "mesh/z_curve.h"
#include "parallel.h"
#include "quality/metrics.h"
#include "smoothing/chart.h"
#include "smoothing/flat_star.h"
#include "smoothing/line_smoothing.h"
#include "smoothing/move_node.h"
#include "smoothing/newton_step.h"
#include "smoothing/optimisation.h"
#include "smoothing/row_end_smoothing.h"
#include "smoothing/row_smoothing.h"
#include "smoothing/shape_relaxation.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

constexpr double kMostStep = 0.2;  ///< of a node, over the mean edge length
constexpr double kLeastStep = 1e-3;
constexpr double kSpan = 0.02;  ///< of differences of the score, over the mean edge length
constexpr double kRelaxation =
    1.6;  ///< successive over-relaxation: half the sweeps, and waves longer than a few edges smooth out at all
constexpr double kAtRest = 5e-3;     ///< moves below this, over the edge length, wake no neighbour
constexpr double kLeastGain = 1e-4;  ///< of the mean or the smallest scaled Jacobian, for another sweep
constexpr double kLeastScoreGain = 1e-6;
constexpr std::int32_t kNodesOfSlab = 1 << 14;  ///< in the mean
constexpr int kFirstOfRows = 3;  ///< sweep from which nodes of rows slide: not for what the nodes beside them can better

struct Statistics {
    double min = 1.0;
    double mean = 1.0;
    int inverted = 0;
};

Statistics statistics(const SurfaceMesh& mesh) {
    struct Sum {
        Statistics of;
        double quality = 0.0;
        int quads = 0;
    };
    const auto of_block = [&](std::int32_t first, std::int32_t last) {
        Sum s;
        for (std::int32_t i = first; i < last; ++i) {
            const Face f(i);
            if (mesh.is_deleted(f) || !mesh.is_quad(f)) continue;
            const double q = scaled_jacobian(mesh, f);
            s.of.min = std::min(s.of.min, q);
            s.of.inverted += q <= kLeastUpright ? 1 : 0;
            s.quality += q;
            ++s.quads;
        }
        return s;
    };
    Sum s = reduce_blocks(mesh.face_slots(), Sum{}, of_block, [](const Sum& a, const Sum& b) {
        return Sum{{std::min(a.of.min, b.of.min), 1.0, a.of.inverted + b.of.inverted}, a.quality + b.quality, a.quads + b.quads};
    });
    if (s.quads > 0) s.of.mean = s.quality / s.quads;
    return s.of;
}

class FinalSmoother {
  public:
    /// @param sweeps how many there will be at most
    FinalSmoother(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines, int sweeps)
        : mesh_(mesh),
          reference_(reference),
          lines_(lines),
          first_of_rows_(std::min(kFirstOfRows, sweeps)),
          hint_(static_cast<std::size_t>(mesh.vertex_slots()), -1),
          awake_(static_cast<std::size_t>(mesh.vertex_slots()), 0) {
        find_rounds();
    }

    /// Visits the nodes that are due: those of a list one after the other, the lists of a round side by side.
    /// @returns number of moves
    /// @throws Error{cancelled}
    int sweep(int number, const Context& context) {
        int moves = 0;
        for (const Round& round : rounds_) {
            const auto lists = static_cast<std::int32_t>(round.size());
            std::vector<int> moves_of(round.size(), 0);
            for_each_task(lists, context, [&](std::int32_t i) {
                for (const Vertex v : round[static_cast<std::size_t>(i)])
                    moves_of[static_cast<std::size_t>(i)] += visit_if_due(v, number) ? 1 : 0;
            });
            moves = std::accumulate(moves_of.begin(), moves_of.end(), moves);
        }
        return moves;
    }

  private:
    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.index()); }

    /// Lists of nodes. Stars of nodes of different lists share no node.
    using Round = std::vector<std::vector<Vertex>>;

    /// First the nodes whose star lies in one block, in a list for each block, which are near each other; then of the rest, near
    /// the borders of the blocks, those whose star lies in one slab; then all others, so few that they come one after the other.
    void find_rounds() {
        std::vector<Vertex> nodes;
        std::vector<Point> places;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid()) continue;
            nodes.push_back(v);
            places.push_back(mesh_.position(v));
        }
        const std::vector<std::int32_t> order = order_along_z_curve(places);
        std::vector<std::int32_t> list(static_cast<std::size_t>(mesh_.vertex_slots()), -1);
        for (std::size_t i = 0; i < order.size(); ++i)
            list[index(nodes[static_cast<std::size_t>(order[i])])] = static_cast<std::int32_t>(i) / kBlock;
        add_round(nodes, list);

        Eigen::AlignedBox3d box;
        for (const Point& p : places) box.extend(p);
        int axis = 0;
        if (!box.isEmpty()) box.sizes().maxCoeff(&axis);
        const std::int32_t slabs = std::max(1, static_cast<std::int32_t>(places.size()) / kNodesOfSlab);
        const double width = box.isEmpty() ? 0.0 : box.sizes()[axis] / slabs;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (list[static_cast<std::size_t>(i)] < 0) continue;  // not in use, and anywhere
            const double place = mesh_.position(Vertex(i))[axis] - box.min()[axis];
            list[static_cast<std::size_t>(i)] =
                width > 0.0 ? static_cast<std::int32_t>(std::clamp(place / width, 0.0, slabs - 1.0)) : 0;
        }
        add_round(nodes, list);
        if (!nodes.empty()) rounds_.push_back({nodes});
    }

    /// @param nodes in the order of their slots; those that get into a list of the round are taken out
    /// @param list per vertex slot, 0 …
    void add_round(std::vector<Vertex>& nodes, std::span<const std::int32_t> list) {
        std::vector<char> is_inner(nodes.size());
        for_each(static_cast<std::int32_t>(nodes.size()), [&](std::int32_t i) {
            is_inner[static_cast<std::size_t>(i)] = is_star_in_list(nodes[static_cast<std::size_t>(i)], list) ? 1 : 0;
        });
        Round round;
        std::vector<Vertex> others;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const auto l = static_cast<std::size_t>(list[index(nodes[i])]);
            if (round.size() <= l) round.resize(l + 1);
            (is_inner[i] ? round[l] : others).push_back(nodes[i]);
        }
        nodes = std::move(others);
        rounds_.push_back(std::move(round));
    }

    bool is_star_in_list(Vertex v, std::span<const std::int32_t> list) const {
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (list[index(mesh_.to(h))] != list[index(v)]) return false;
            if (mesh_.is_boundary(h)) continue;
            for (const HalfEdge g : mesh_.halfedges(mesh_.face(h))) {
                if (list[index(mesh_.from(g))] != list[index(v)]) return false;
            }
        }
        return true;
    }

    /// Something moved round the node in this sweep or the last one; nodes of rows wait for their first sweep, in which all are
    /// due.
    bool is_due(Vertex v, int number) const {
        if (mesh_.info(v).in_row && number <= first_of_rows_) return number == first_of_rows_;
        return awake_[index(v)] + 1 >= number;
    }

    bool visit_if_due(Vertex v, int number) {
        if (!is_due(v, number)) return false;
        const Point before = mesh_.position(v);
        const double edge = mesh_.length(mesh_.halfedge(v));
        if (!visit(v)) return false;
        if ((mesh_.position(v) - before).norm() > kAtRest * edge) wake_neighbours(v, number);
        return true;
    }

    bool visit(Vertex v) {
        if (mesh_.info(v).kind != NodeKind::interior) {
            if (lines_.empty()) return slide_on_line(mesh_, v);
            if (reference_.target()) return slide_on_target(mesh_, v, lines_, reference_.target());
            return slide_on_line(mesh_, v) || slide_on_curve(mesh_, v, lines_);
        }
        if (hint_[index(v)] < 0) hint_[index(v)] = hint_of_neighbour(v);
        if (mesh_.info(v).in_row) return slide_if_poor(v);
        if (!is_movable(mesh_, v)) return false;
        // An untangled star first; then the mean; then the worst, where the mean alone leaves a poor element.
        double worst = 1.0;
        FlatStar flat;
        const bool moved = flat.gather(mesh_, v) && flat.has_quads_only() ? relax_flat(v, flat, worst) : relax(v, worst);
        if (worst >= Star::kPoor) return moved;
        return optimise_node(mesh_, v, &reference_, &hint_[index(v)], Aim::worst_changing_corner) || moved;
    }

    bool slide_if_poor(Vertex v) {
        Star star;
        if (!star.gather(mesh_, v)) return false;
        star.see_along_surface(reference_, hint_[index(v)]);
        return star.quality(star.centre()).worst < Star::kPoor && slide_in_row(mesh_, v, &reference_, &hint_[index(v)]);
    }

    /// A node that was visited before spares the search from the tree's root; the star of a node lies in its list, or no other
    /// list is visited, so that the facet is the same for any number of threads.
    std::int32_t hint_of_neighbour(Vertex v) const {
        for (const HalfEdge h : mesh_.outgoing(v)) {
            const std::int32_t hint = hint_[index(mesh_.to(h))];
            if (hint >= 0) return hint;
        }
        return -1;
    }

    /// Moves the node towards where its star scores best, see Star::Quality::score(). With the mean sine of all corners the mean
    /// scaled Jacobian of a plane becomes 0.998, its 5th percentile 0.993; with the mean of the quads' least sines, whose kinks
    /// hold the nodes, 0.994 and 0.968.
    /// @param worst receives Quality::worst_changing in the end; where a face is inverted, the node stays
    bool relax(Vertex v, double& worst) {
        Star star;
        if (!star.gather(mesh_, v)) return false;
        star.see_along_surface(reference_, hint_[index(v)]);
        const auto quality = [&](const Point& p) { return star.quality(p); };
        const Star::Quality before = quality(star.centre());
        worst = before.worst_changing;
        if (before.worst <= 0.0) return false;
        const Chart chart(mesh_, v, star);
        const auto score = [&](const Eigen::Vector2d& x) { return quality(chart(x)).score(); };
        const Eigen::Vector2d x = newton_search(score, kSpan * star.edge_length(), kRelaxation, kMostStep * star.edge_length());
        return step(v, star, before, x, chart, quality, worst);
    }

    /// The same in the tangent plane, where the derivatives are known.
    bool relax_flat(Vertex v, FlatStar& star, double& worst) {
        const FlatStar::Expansion here = star.expand();
        worst = here.quality.worst_changing;
        if (here.quality.worst <= 0.0) return false;
        const Eigen::Vector2d x = newton_step(here.gradient, here.hessian, kRelaxation, kMostStep * star.edge_length());
        // What a quadratic model of the score promises.
        if (here.gradient.dot(x) + 0.5 * x.dot(here.hessian * x) < kLeastScoreGain) return false;
        return step(
            v, star, here.quality, x, star, [&](const Point& p) { return star.quality(p); }, worst);
    }

    /// Makes the step, or as much of it as raises the score and leaves no poor element poorer.
    /// @param star Star or FlatStar; @param place point in space of x; @param quality of the faces with the node at a point
    template <class AnyStar, class Place, class Quality>
    bool step(Vertex v, AnyStar& star, const Star::Quality& before, Eigen::Vector2d x, const Place& place, const Quality& quality,
              double& worst) {
        std::int32_t facet = hint_[index(v)];
        for (int i = 0; i < 3 && x.norm() > kLeastStep * star.edge_length(); ++i, x *= 0.5) {
            const Point p = reference_.project(place(x), {star.patch(), star.normal()}, facet);
            const Star::Quality after = quality(p);
            if (!(after.score() > before.score() + kLeastScoreGain)) continue;
            if (after.worst_changing < before.worst_changing && after.worst_changing < Star::kPoor) continue;
            if (!star.stays_near(reference_, p)) continue;
            mesh_.position(v) = p;
            mesh_.info(v).input = -1;
            hint_[index(v)] = facet;
            worst = after.worst_changing;
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
    int first_of_rows_;  ///< sweep from which nodes of rows slide
    std::vector<Round> rounds_;
    std::vector<std::int32_t> hint_;   ///< facet of the reference surface near each node
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

FinalSmoothingResult smooth_mesh(SurfaceMesh& mesh, const ReferenceSurface& reference, const Options& options, Context& context,
                                 const ReferenceLines& lines) {
    FinalSmoothingResult result;
    Statistics last = statistics(mesh);
    result.min_before = last.min;
    result.mean_before = last.mean;
    release_nodes_without_rows(mesh);
    if (options.smoothing_passes > 0) {
        result.moves += smooth_rows(mesh, &reference).moved;
        result.moves += relax_shapes(mesh, reference, context);
    }

    FinalSmoother smoother(mesh, reference, lines, options.smoothing_passes);
    while (result.sweeps < options.smoothing_passes) {
        const double done = static_cast<double>(result.sweeps) / options.smoothing_passes;
        context.report(done);
        const int moves = smoother.sweep(++result.sweeps, context);
        result.moves += moves;
        const Statistics now = statistics(mesh);
        const bool at_rest =
            now.min < last.min + kLeastGain && now.mean < last.mean + kLeastGain && now.inverted >= last.inverted;
        last = now;
        if (result.sweeps >= kFirstOfRows && (moves == 0 || at_rest)) break;
    }
    const int at_row_ends = options.smoothing_passes > 0 ? even_row_ends(mesh, reference, lines, context) : 0;
    if (at_row_ends > 0) last = statistics(mesh);
    result.moves += at_row_ends;
    result.min_after = last.min;
    result.mean_after = last.mean;
    result.inverted = last.inverted;
    return result;
}

}  // namespace anisoquad
