#include "smoothing/row_end_smoothing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "quality/metrics.h"
#include "smoothing/chart.h"
#include "smoothing/line_smoothing.h"
#include "smoothing/move_node.h"
#include "smoothing/pattern_search.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr int kSweeps = 20;
constexpr double kFirstStep = 0.2;  ///< over the mean edge length
constexpr double kSmallestStep = 5e-3;
constexpr double kLeastGain = 1e-4;
constexpr double kLongestRatio = 5.0;    ///< of a quad's edges, of what was less stretched before
constexpr double kOfRowsRatio = 0.75;    ///< the same, over the ratio of the row's quad beside it: with the row's length, a quad
                                         ///< of twice the row's area has half of it
constexpr double kQualityWeight = 0.05;  ///< of the star's score beside the sizes
constexpr double kLeastQuality = 0.55;   ///< scaled Jacobian of what was no worse

/// True for the outer side of an edge between a quad of a row and another one.
bool is_row_end(const SurfaceMesh& mesh, HalfEdge outer) {
    if (mesh.is_constrained(M::edge(outer))) return false;
    const Face f = mesh.face(outer);
    const Face row = mesh.face(M::twin(outer));
    return mesh.info(f).row <= 0 && mesh.info(row).row > 0 && mesh.is_quad(f) && mesh.is_quad(row);
}

/// How far two areas are beyond kMostSizeRatio; 0 = not.
double excess(double a, double b) {
    const double ratio = std::abs(std::log(a / b)) - std::log(kMostSizeRatio);
    return ratio > 0.0 ? ratio : 0.0;
}

/// Longest over shortest edge.
double edge_ratio(const SurfaceMesh& mesh, Face f) {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (const HalfEdge h : mesh.halfedges(f)) {
        shortest = std::min(shortest, mesh.length(h));
        longest = std::max(longest, mesh.length(h));
    }
    return shortest > 0.0 ? longest / shortest : 1.0;
}

/// The quads at a node that lie beside a row's end, for trial places of the node.
class EndsOfStar {
  public:
    EndsOfStar(const SurfaceMesh& mesh, Vertex v) {
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (mesh.is_boundary(h) || mesh.info(mesh.face(h)).row > 0 || !mesh.is_quad(mesh.face(h))) continue;
            for (const HalfEdge g : mesh.halfedges(mesh.face(h))) {
                if (!is_row_end(mesh, g)) continue;
                const HalfEdge next = mesh.next(h);
                const Face row = mesh.face(M::twin(g));
                ends_.push_back({mesh.position(mesh.from(next)), mesh.position(mesh.to(next)),
                                 mesh.position(mesh.from(mesh.prev(h))), area(mesh, row)});
                rows_ratio_ = std::max(rows_ratio_, edge_ratio(mesh, row));
            }
        }
    }
    /// Sum of squares, with the node at p.
    double excess_at(const Point& p) const {
        double sum = 0.0;
        for (const End& end : ends_) {
            const double e = excess(area(p, end.next, end.opposite, end.previous), end.row_area);
            sum += e * e;
        }
        return sum;
    }

    /// The largest ratio of the edges of a row's quad beside them.
    double rows_ratio() const { return rows_ratio_; }

  private:
    struct End {
        Point next, opposite, previous;
        double row_area;
    };
    std::vector<End> ends_;
    double rows_ratio_ = 1.0;
};

/// What places of one node are worth.
class Worth {
  public:
    Worth(const SurfaceMesh& mesh, Vertex v, const Star& star) : star_(star), ends_(mesh, v) {
        const Star::Quality now = star.quality(star.centre());
        least_ = std::min(now.worst, kLeastQuality);
        longest_ = std::max({now.ratio, kLongestRatio, kOfRowsRatio * ends_.rows_ratio()});
    }
    bool is_upright() const { return least_ > 0.0; }
    double operator()(const Point& p) const {
        const Star::Quality q = star_.quality(p);
        if (q.worst < least_ || q.ratio > longest_) return -std::numeric_limits<double>::infinity();
        return kQualityWeight * q.score() - ends_.excess_at(p);
    }

  private:
    const Star& star_;
    EndsOfStar ends_;
    double least_ = 0.0;
    double longest_ = 0.0;
};

bool move_on_surface(SurfaceMesh& mesh, Vertex v, const ReferenceSurface& reference, std::int32_t& facet) {
    Star star;
    if (!is_movable(mesh, v) || !star.gather(mesh, v)) return false;
    star.see_along_surface(reference, facet);
    const Worth worth(mesh, v, star);
    if (!worth.is_upright()) return false;
    const Chart chart(mesh, v, star);
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    pattern_search([&](const Eigen::Vector2d& trial) { return worth(chart(trial)); }, x, kFirstStep * star.edge_length(),
                   kSmallestStep * star.edge_length());
    if (x.isZero(0.0)) return false;
    const Point p = reference.project(chart(x), {star.patch(), star.normal()}, facet);
    if (!p.allFinite() || !(worth(p) > worth(star.centre()) + kLeastGain) || !star.stays_near(reference, p)) return false;
    mesh.position(v) = p;
    mesh.info(v).input = -1;
    return true;
}

bool move_on_line(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines) {
    Star star;
    if (lines.empty() || mesh.info(v).kind != NodeKind::line || !star.gather(mesh, v)) return false;
    star.use_face_normals();
    const Worth worth(mesh, v, star);
    return worth.is_upright() && slide_on_curve_towards(mesh, v, lines, worth);
}

}  // namespace

int even_row_ends(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines, const Context& context) {
    std::vector<HalfEdge> ends;
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        const HalfEdge h(i);
        if (!mesh.is_deleted(h) && !mesh.is_boundary(h) && is_row_end(mesh, h)) ends.push_back(h);
    }
    if (ends.empty()) return 0;
    std::vector<std::int32_t> last_move(static_cast<std::size_t>(mesh.vertex_slots()), 0);  // the sweep of it
    const auto is_due = [&](Vertex v, int sweep) {
        const auto moved = [&](Vertex w) { return last_move[static_cast<std::size_t>(w.index())] + 1 >= sweep; };
        for (const HalfEdge h : mesh.outgoing(v)) {
            if (moved(mesh.to(h)) || (!mesh.is_boundary(h) && moved(mesh.to(mesh.next(h))))) return true;
        }
        return moved(v);
    };
    int moves = 0;
    std::int32_t facet = -1;
    for (int sweep = 1; sweep <= kSweeps; ++sweep) {
        std::vector<Vertex> nodes;
        for (const HalfEdge h : ends) {
            if (excess(area(mesh, mesh.face(h)), area(mesh, mesh.face(M::twin(h)))) <= 0.0) continue;
            for (const HalfEdge g : mesh.halfedges(mesh.face(h))) {
                nodes.push_back(mesh.from(g));
                for (const HalfEdge out : mesh.outgoing(mesh.from(g))) nodes.push_back(mesh.to(out));
            }
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        int moved = 0;
        for (const Vertex v : nodes) {
            const bool slides = mesh.info(v).kind != NodeKind::interior;
            if (slides && reference.target()) continue;  // its curve is another one
            if (!is_due(v, sweep)) continue;
            context.breathe();
            if (!(slides ? move_on_line(mesh, v, lines) : move_on_surface(mesh, v, reference, facet))) continue;
            last_move[static_cast<std::size_t>(v.index())] = sweep;
            ++moved;
        }
        if (moved == 0) break;
        moves += moved;
    }
    return moves;
}

}  // namespace anisoquad
