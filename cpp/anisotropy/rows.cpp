#include "anisotropy/rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "anisotropy/geodesic_trace.h"
#include "anisotropy/put_node.h"
#include "anisotropy/spread.h"
#include "mesh/euler_operators.h"
#include "prepare/remesh.h"
#include "qmorph/edge_recovery.h"
#include "qmorph/front.h"
#include "quality/metrics.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr double kAlongLine = 0.85 * kPi;  // sector up to which the end column runs along the line
constexpr double kFacing = 0.6;            // sine of incidence from which an obstacle lies ahead of a column, not beside it
constexpr double kAhead = 1.3;             // heights that must be free even of lines beside the row
constexpr double kSlimmest = 6.0;          // height over width of one column
constexpr double kSharpTurn = 0.5;         // radians by which the front turns at a corner
constexpr double kLeastQuality = 0.25;     // scaled Jacobian of a row quad
constexpr double kEvenOut = 0.15;          // share of a column's displacement along the row that one row takes back
constexpr double kMostLean = 0.5;          // of a column for that, per height
constexpr double kFirstRow = 0.85;         // height of the first row over the local size: rows only get thicker
constexpr double kLeastGrowthCapped = 1.015;
constexpr double kLeastGrowth = 1.03;       // rows never get thinner away from the source
constexpr int kMostEvened = 8;              // times that the triangles round a row are swapped
constexpr double kEvenDeviation = 1e-3;     // off the surface, over its diagonal, by that
constexpr std::int32_t kRowLine = 1 << 30;  // marks the edges of the row while it is built

class RowBuilder {
  public:
    RowBuilder(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference,
               const RowLimits& limits)
        : mesh_(mesh), stack_(stack), size_(size), reference_(reference), limits_(limits), bottom_(stack.top()) {}

    bool run() {
        columns_ = bottom_.size() - 1;
        stack_.misfit.clear();
        if (!collect_front() || !plan_ends()) return false;
        plan_shear();
        if (!plan_heights()) return false;
        align_columns();
        if (!check_way()) return false;
        const bool built = insert_nodes() && recover_edges() && form_quads();
        for (const Edge e : marked_) {
            if (!mesh_.is_deleted(e) && mesh_.info(e).line == kRowLine) mesh_.info(e).line = -1;
        }
        if (!built) {
            for (const Vertex v : placed_) mesh_.info(v).in_row = false;
        }
        return built;
    }

  private:
    bool stop(const char* why) {
        stack_.stopped = why;
        return false;
    }

    bool stop_at_column(std::size_t i, const char* why) {
        stack_.misfit.resize(columns_, 0);
        stack_.misfit[i] = 1;
        return stop(why);
    }

    /// At a node: the columns on both sides.
    bool stop_at_node(std::size_t i, const char* why) {
        if (i > 0 || stack_.closed) stop_at_column(i > 0 ? i - 1 : columns_ - 1, why);
        if (i < columns_ || stack_.closed) stop_at_column(i < columns_ ? i : 0, why);
        return false;
    }

    const Point& at(Vertex v) const { return mesh_.position(v); }

    bool collect_front() {
        front_.clear();
        bool is_free = true;
        for (std::size_t i = 0; i < columns_; ++i) {
            front_.push_back(mesh_.find_halfedge(bottom_[i], bottom_[i + 1]));
            if (!front_[i].is_valid() || !is_front(mesh_, front_[i]))
                is_free = stop_at_column(i, "another row or the boundary lies directly ahead");
        }
        return is_free;
    }

    /// Front edge that ends at node i.
    HalfEdge into(std::size_t i) const {
        if (i > 0) return front_[i - 1];
        return stack_.closed ? front_.back() : previous_front(mesh_, front_[0]);
    }

    bool is_end(std::size_t i) const { return !stack_.closed && (i == 0 || i == columns_); }

    /// At open ends: run along the line (fixed node), or free at a right angle.
    bool plan_ends() {
        top_.assign(columns_ + 1, Vertex());
        angle_.assign(columns_ + 1, 0.0);
        shear_.assign(columns_ + 1, 0.0);
        bool fits = true;
        for (std::size_t i = 0; i <= columns_; ++i) {
            const HalfEdge in = into(i);
            const double sector = front_angle(mesh_, in);
            angle_[i] = 0.5 * sector;
            if (!is_end(i)) {
                if (sector < 0.3 * kPi) fits = stop_at_node(i, "the front turns too sharply for one more row");
                continue;
            }
            const HalfEdge line = i == 0 ? in : next_front(mesh_, in);
            if (sector < kAlongLine) {
                top_[i] = i == 0 ? mesh_.from(line) : mesh_.to(line);
                if (std::find(bottom_.begin(), bottom_.end(), top_[i]) != bottom_.end()) {
                    fits = stop_at_node(i, "the line at the row's end turns back to it");
                    continue;
                }
                if (mesh_.info(top_[i]).kind == NodeKind::corner) {
                    fits = stop_at_node(i, "the end column reaches a corner of the feature lines");
                    continue;
                }
                shear_[i] = (i == 0 ? 1.0 : -1.0) / std::tan(std::clamp(sector, 0.15 * kPi, 0.85 * kPi));
            } else {
                angle_[i] = i == 0 ? std::max(0.5 * sector, sector - 0.5 * kPi) : std::min(0.5 * sector, 0.5 * kPi);
            }
        }
        return fits;
    }

    /// Columns over which a value that an end forces on the row fades.
    double reach() const { return std::max(3.0, static_cast<double>(columns_) / 3.0); }

    /// Fractions of its length at which the nodes of a layer lie.
    std::vector<double> fractions(const std::vector<Vertex>& layer) const {
        std::vector<double> at_node(layer.size(), 0.0);
        for (std::size_t i = 1; i < layer.size(); ++i) at_node[i] = at_node[i - 1] + (at(layer[i]) - at(layer[i - 1])).norm();
        for (double& f : at_node) f /= at_node.back();
        return at_node;
    }

    /// Lean per column end that leads the columns back to the share of the row's length that they have on the source, so that
    /// those squeezed at one end give way all along the row.
    std::vector<double> lean_to_even_columns() const {
        std::vector<double> lean(columns_ + 1, 0.0);
        if (stack_.closed || stack_.rows() == 0) return lean;
        const std::vector<double> source = fractions(stack_.layers[0]);
        const std::vector<double> here = fractions(bottom_);
        double length = 0.0;
        for (const HalfEdge h : front_) length += mesh_.length(h);
        for (std::size_t i = 1; i < columns_; ++i) {
            const double height = std::max(stack_.height(mesh_, i), 1e-3 * length);
            lean[i] = std::clamp(kEvenOut * (source[i] - here[i]) * length / height, -kMostLean, kMostLean);
        }
        return lean;
    }

    /// Columns lean along the source by `shear_` heights per height: as the lines at the ends force the end columns to, and
    /// towards even columns; in between the lean fades over a third of the row, so that
    /// columns that come together at one end are squeezed all alike.
    void plan_shear() {
        const std::vector<double> wanted = lean_to_even_columns();
        spread(shear_, std::vector<double>(columns_ + 1, 0.0), reach(), stack_.closed);
        for (std::size_t i = 0; i <= columns_; ++i) {
            if (is_end(i)) continue;
            shear_[i] = std::clamp(shear_[i] + wanted[i], -1.5, 1.5);
            const double sector = 2.0 * angle_[i];
            angle_[i] = std::clamp(angle_[i] + std::atan(shear_[i]), 0.15 * sector, 0.85 * sector);
        }
    }

    /// Height that the end columns get from the nodes of the lines they run along.
    double smallest_end_height() const {
        double height = 1e300;
        for (const std::size_t i : {std::size_t{0}, columns_}) {
            if (top_[i].is_valid()) height = std::min(height, (at(top_[i]) - at(bottom_[i])).norm() / std::hypot(1.0, shear_[i]));
        }
        return height;
    }

    bool plan_heights() {
        height_.assign(columns_ + 1, 0.0);
        std::vector<double> low(columns_ + 1, 0.0);
        std::vector<double> high(columns_ + 1, 0.0);
        std::int32_t hint = -1;
        const double cap = limits_.over_ends * smallest_end_height();
        for (std::size_t i = 0; i <= columns_; ++i) {
            // The size where the row's middle will be, not where it starts.
            const double before = stack_.height(mesh_, i);
            const TraceEnd ahead =
                trace_geodesic(mesh_, into(i), angle_[i], before > 0.0 ? before : 1e-3 * mesh_.length(into(i)));
            const double local = size_(ahead.position, hint);
            const double share = before > 0.0 ? 1.0 : kFirstRow;
            // Options.row_growth may ask for less growth than the rows like.
            low[i] = before > 0.0 ? before * std::min(before > cap ? kLeastGrowthCapped : kLeastGrowth, limits_.growth) : 0.0;
            high[i] = before > 0.0 ? before * limits_.growth : 1e300;
            const double width =
                0.5 * (mesh_.length(front_[i > 0 ? i - 1 : 0]) + mesh_.length(front_[i < columns_ ? i : columns_ - 1]));
            const double least = limits_.height_of_width * width;
            height_[i] = top_[i].is_valid() ? (at(top_[i]) - at(bottom_[i])).norm() / std::hypot(1.0, shear_[i])
                                            : std::clamp(share * std::min(std::max(local, least), cap), low[i], high[i]);
        }
        // A column on a line has the height that the line's nodes give; the others lead over to it slowly, or the rows tilt.
        const std::vector<double> local = height_;
        spread(height_, local, reach(), stack_.closed);
        std::size_t slim = 0;
        bool fits = true;
        for (std::size_t i = 0; i < columns_; ++i) {
            const double width = mesh_.length(front_[i]);
            const double height = 0.5 * (height_[i] + height_[i + 1]);
            if (height > kSlimmest * width) fits = stop_at_column(i, "a column has become too slim");
            slim += height > limits_.longest_height * width;
        }
        if (!fits || 4 * slim <= columns_) return fits;
        return stop("the triangles ahead are too large for the length of the front's edges");
    }

    /// Neighbouring columns run alike: their displacements are averaged over a few columns, or the bisectors of a slightly uneven
    /// front would focus and spread the columns more with every row. Sharp turns of the front keep their own.
    void align_columns() {
        std::vector<Vector3d> column(columns_ + 1);
        for (std::size_t i = 0; i <= columns_; ++i) {
            const Point end = top_[i].is_valid() ? at(top_[i]) : trace_geodesic(mesh_, into(i), angle_[i], way(i)).position;
            column[i] = end - at(bottom_[i]);
        }
        std::vector<Vector3d> smooth = column;
        std::vector<Vector3d> next = column;
        for (int sweep = 0; sweep < 12; ++sweep) {
            for (std::size_t i = 0; i <= columns_; ++i) {
                if (is_end(i) || turns_sharply(i)) continue;
                const std::size_t before = i > 0 ? i - 1 : columns_ - 1;
                const std::size_t after = i < columns_ ? i + 1 : 1;
                next[i] = 0.5 * smooth[i] + 0.25 * (smooth[before] + smooth[after]);
            }
            smooth.swap(next);
        }
        for (std::size_t i = 0; i <= columns_; ++i) {
            if (is_end(i) || turns_sharply(i)) continue;
            const double length = column[i].norm();
            const Vector3d along = (at(bottom_[i < columns_ ? i + 1 : 1]) - at(mesh_.from(into(i)))).normalized();
            const double shift = (smooth[i] * (length / smooth[i].norm()) - column[i]).dot(along) / length;
            const double sector = front_angle(mesh_, into(i));
            angle_[i] = std::clamp(angle_[i] + std::asin(std::clamp(shift, -0.7, 0.7)), 0.15 * sector, 0.85 * sector);
        }
    }

    bool turns_sharply(std::size_t i) const { return std::abs(front_angle(mesh_, into(i)) - kPi) > kSharpTurn; }

    /// Way along the column from the source.
    double depth(std::size_t i) const {
        if (stack_.rows() == 0) return 0.0;
        double sum = 0.0;
        for (std::size_t j = 1; j < stack_.layers.size(); ++j)
            sum += (at(stack_.layers[j][i]) - at(stack_.layers[j - 1][i])).norm();
        return sum;
    }

    /// Enough free surface ahead of every column.
    bool check_way() {
        bool is_free = true;
        for (std::size_t i = 0; i <= columns_; ++i) {
            if (top_[i].is_valid()) continue;
            const double share = limits_.free_share / (1.0 - limits_.free_share);
            const double needed = std::max(way(i) * limits_.clearance, share * (depth(i) + way(i)) + way(i));
            const TraceEnd end = trace_geodesic(mesh_, into(i), angle_[i], needed);
            // A line that the column meets at a flat angle runs beside the row, as those at its ends do: only the row itself
            // counts.
            const bool ahead = end.incidence > kFacing || end.length < kAhead * way(i);
            if (end.blocked && ahead) is_free = stop_at_node(i, "a boundary, a feature line or another row is too close ahead");
        }
        return is_free;
    }

    /// Way along the column for the wanted height across the row.
    double way(std::size_t i) const {
        const double half = angle_[i] - std::atan(shear_[i]);
        const double across = is_end(i) ? 1.0 : std::clamp(std::sin(std::min(half, kPi - half)), 0.7, 1.0);
        return height_[i] * std::hypot(1.0, shear_[i]) / across;
    }

    bool insert_nodes() {
        for (std::size_t i = 0; i <= columns_; ++i) {
            if (top_[i].is_valid()) continue;
            if (stack_.closed && i == columns_) {
                top_[i] = top_[0];
                continue;
            }
            const TraceEnd end = trace_geodesic(mesh_, into(i), angle_[i], way(i));
            if (end.blocked) return stop_at_node(i, "a boundary, a feature line or another row is too close ahead");
            top_[i] = put_node(mesh_, end, 0.3 * std::min(way(i), mesh_.length(into(i))));
            mesh_.info(top_[i]).in_row = true;  // from here on nothing else moves it
            placed_.push_back(top_[i]);
            std::int32_t hint = -1;
            const Point kept = at(top_[i]);
            const double before = worst_quality(mesh_, top_[i], node_normal(mesh_, top_[i]));
            mesh_.position(top_[i]) = reference_.project(kept, mesh_.info(end.face).patch, hint);
            if (worst_quality(mesh_, top_[i], node_normal(mesh_, top_[i])) < std::min(1e-3, before))
                mesh_.position(top_[i]) = kept;
        }
        bool fits = true;
        for (std::size_t i = 0; i < columns_; ++i) {
            const Vector3d normal =
                sector_normal(mesh_, into(i)) + sector_normal(mesh_, into(i + 1 < columns_ || !stack_.closed ? i + 1 : 0));
            const double q = scaled_jacobian(at(bottom_[i]), at(bottom_[i + 1]), at(top_[i + 1]), at(top_[i]), normal);
            if (q < kLeastQuality) fits = stop_at_column(i, "a quad of the row would be too distorted");
        }
        return fits;
    }

    bool recover(Vertex a, Vertex b) {
        HalfEdge h = recover_edge(mesh_, a, b);
        if (!h.is_valid() && evened_ < kMostEvened) {
            even_out();
            h = recover_edge(mesh_, a, b);
        }
        if (!h.is_valid()) return false;
        const Edge e = M::edge(h);
        if (mesh_.info(e).line < 0) {
            mesh_.info(e).line = kRowLine;
            marked_.push_back(e);
        }
        return true;
    }

    /// Nodes that were put into long triangles leave slivers, between which no edge can be swapped: Delaunay's triangles round
    /// the row are better.
    void even_out() {
        std::vector<char> zone(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (const auto& layer : {bottom_, top_}) {
            for (const Vertex v : layer) {
                for (const HalfEdge h : mesh_.outgoing(v)) zone[static_cast<std::size_t>(mesh_.to(h).index())] = 1;
            }
        }
        swap_towards_delaunay(mesh_, zone, reference_, {.deviation = kEvenDeviation});
        ++evened_;
    }

    bool recover_edges() {
        for (std::size_t i = 0; i <= columns_; ++i) {
            if (!recover(bottom_[i], top_[i]))
                return stop_at_node(i, "the triangles ahead could not be swapped into the row (column)");
        }
        for (std::size_t i = 0; i < columns_; ++i) {
            if (!recover(top_[i + 1], top_[i]))
                return stop_at_column(i, "the triangles ahead could not be swapped into the row (top)");
        }
        return true;
    }

    std::array<HalfEdge, 4> loop_of(std::size_t i) const {
        return {mesh_.find_halfedge(bottom_[i], bottom_[i + 1]), mesh_.find_halfedge(bottom_[i + 1], top_[i + 1]),
                mesh_.find_halfedge(top_[i + 1], top_[i]), mesh_.find_halfedge(top_[i], bottom_[i])};
    }

    bool form_quads() {
        std::vector<Face> faces;
        for (std::size_t i = 0; i < columns_; ++i) {
            if (!collect_region(mesh_, loop_of(i), faces)) return stop_at_column(i, "something lies inside the row");
        }
        const auto row = static_cast<std::int32_t>(stack_.rows()) + 1;
        for (std::size_t i = 0; i < columns_; ++i) {
            const auto loop = loop_of(i);
            collect_region(mesh_, loop, faces);
            FaceInfo& info = mesh_.info(replace_region(mesh_, loop, faces));
            info.row = row;
            info.pass = limits_.pass;
            info.source = stack_.source;
        }
        for (const Vertex v : bottom_) mesh_.info(v).in_row = true;
        for (const Vertex v : top_) mesh_.info(v).in_row = true;
        stack_.layers.push_back(top_);
        stack_.pass_of_row.push_back(limits_.pass);
        return true;
    }

    SurfaceMesh& mesh_;
    RowStack& stack_;
    const LocalSize& size_;
    const ReferenceSurface& reference_;
    const RowLimits& limits_;
    const std::vector<Vertex> bottom_;
    std::size_t columns_ = 0;
    std::vector<HalfEdge> front_;
    std::vector<Vertex> top_;
    std::vector<double> angle_;
    std::vector<double> shear_;
    std::vector<double> height_;
    std::vector<Edge> marked_;
    std::vector<Vertex> placed_;
    int evened_ = 0;
};

}  // namespace

bool build_row(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference,
               const RowLimits& limits) {
    return RowBuilder(mesh, stack, size, reference, limits).run();
}

}  // namespace anisoquad
