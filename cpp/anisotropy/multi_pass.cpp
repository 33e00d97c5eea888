#include "anisotropy/multi_pass.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "anisotropy/geodesic_trace.h"
#include "anisotropy/line_across.h"
#include "anisotropy/merge.h"
#include "anisotropy/rows.h"
#include "anisotropy/segmentation.h"
#include "anisotropy/source_sides.h"
#include "anisotropy/split_stack.h"
#include "anisotropy/transition.h"
#include "mesh/area_vector.h"
#include "prepare/remesh.h"
#include "qmorph/front.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kLongestHeight = 1.6;    // of a row over the width of its columns, see RowLimits
constexpr double kLaterHeight = 0.5;      // wanted height of later passes' rows over the length of their front edges
constexpr double kFreeShare = 0.3;        // of the way to the next obstacle that the last pass leaves free
constexpr double kFreeShareLater = 0.1;   // more for each later pass
constexpr double kReserve = 3.0;          // heights that are left to each later pass
constexpr int kMostClosing = 4;           // rows that lead over from the last pass to isotropic quads
constexpr double kClosingGrowth = 1.6;    // of their height, from one to the next
constexpr double kClosingOverEnds = 2.5;  // their height over that of the end columns
constexpr double kFreeClosing = 0.35;     // of the way to the next obstacle that they leave free: isotropic quads need it more
constexpr double kClosedAspect = 1.6;     // width over height of the uppermost row that needs none of them
constexpr double kFreeAhead = 1.0;        // free way ahead of the rows over the length of a merged edge
constexpr double kColumnAtEnd = 1.0;      // least width of the merged end columns over the height of the uppermost row
constexpr double kEvenDeviation = 1e-3;   // off the surface, over its diagonal, by swaps where a side has no rows
constexpr std::size_t kFewRows = 3;       // of a pass (one is given back), before which a stack is split where columns do not fit
constexpr int kLeastSegments = 4;         // merged edges that a part of a split stack has room for
constexpr double kSagitta = 0.25;         // of a merged edge over the height of the first row
constexpr double kFeatureSagitta = 5e-5;  // the same where the source is a feature line, over the model's diagonal
constexpr double kAheadSagitta = 1.3e-3;  // of the squares that follow the rows, over the model's diagonal

/// A source with its nodes of the moment.
struct Line {
    std::vector<Vertex> nodes;
    std::vector<Point> original;     ///< the picked polyline
    std::vector<std::size_t> index;  ///< of each node in it
    std::vector<char> sharp;         ///< per edge of it: a feature line too, or the boundary
    bool closed = false;
};

class MultiPass {
  public:
    MultiPass(SurfaceMesh& mesh, std::span<const Source> sources, const LocalSize& size, const ReferenceSurface& reference,
              const Options& options, const StageObserver& observe, Context& context)
        : mesh_(mesh),
          sources_(sources),
          size_(size),
          reference_(reference),
          options_(options),
          observe_(observe),
          context_(context) {}

    MultiPassResult run() {
        stacks_ = source_sides(mesh_, sources_);
        for (const Source& source : sources_) {
            Line line;
            line.closed = source.vertices.front() == source.vertices.back();
            for (std::size_t i = 0; i < source.vertices.size(); ++i) {
                line.nodes.emplace_back(source.vertices[i]);
                line.original.push_back(mesh_.position(line.nodes.back()));
                line.index.push_back(i);
                if (i > 0) line.sharp.push_back(is_sharp(mesh_.find_halfedge(line.nodes[i - 1], line.nodes[i])));
            }
            lines_.push_back(std::move(line));
            pass_count_ = std::max(pass_count_, source.passes.size());
        }
        for (const RowStack& stack : stacks_) {
            for (const Vertex v : stack.layers[0]) mesh_.info(v).in_row = true;
        }
        for (std::size_t p = 0; p < pass_count_; ++p) {
            context_.report(static_cast<double>(p) / static_cast<double>(pass_count_));
            run_pass(p);
        }
        std::vector<std::vector<Vertex>> merged;
        for (const Line& line : lines_) merged.push_back(line.nodes);
        thin_lines_across(mesh_, std::move(merged), kFeatureSagitta * reference_.diagonal(), reference_, context_);
        return std::move(result_);
    }

  private:
    const Pass* pass_of(const RowStack& stack, std::size_t p) const {
        const auto& passes = sources_[static_cast<std::size_t>(stack.source)].passes;
        return p < passes.size() ? &passes[p] : nullptr;
    }

    void run_pass(std::size_t p) {
        advance_rows(p);
        const std::string name = "pass " + std::to_string(p + 1);
        if (observe_) observe_(name + ": rows");
        std::vector<std::size_t> columns;
        for (const RowStack& stack : stacks_) columns.push_back(stack.columns());
        std::vector<char> merged;
        for (std::size_t s = 0; s < sources_.size(); ++s) merge_source(s, p, merged);
        if (std::find(merged.begin(), merged.end(), 1) != merged.end())
            swap_towards_delaunay(mesh_, merged, reference_, {.deviation = kEvenDeviation});
        close_rows(p);
        for (std::size_t i = 0; i < stacks_.size(); ++i) {
            const Pass* pass = pass_of(stacks_[i], p);
            if (!pass) continue;
            const std::size_t rows = stacks_[i].rows();
            result_.passes.push_back(
                {stacks_[i].source, static_cast<std::int32_t>(p) + 1, stacks_[i].left ? "left" : "right", pass->ratio,
                 static_cast<std::int32_t>(rows > stacks_[i].rows_before ? rows - stacks_[i].rows_before : 0),
                 static_cast<std::int32_t>(columns[i]), stacks_[i].stopped});
        }
        if (observe_) observe_(name + ": merge");
    }

    /// All stacks in step: one row each, until none can go on.
    void advance_rows(std::size_t p) {
        stacks_ = join_stacks(std::move(stacks_));
        for (RowStack& stack : stacks_) {
            stack.rows_before = stack.rows();
            stack.is_running = pass_of(stack, p) != nullptr;
        }
        const auto is_running = [](const RowStack& stack) { return stack.is_running; };
        for (int step = 0; std::any_of(stacks_.begin(), stacks_.end(), is_running); ++step) {
            for (std::size_t i = 0; i < stacks_.size(); ++i) {
                if (!stacks_[i].is_running) continue;
                const Pass& pass = *pass_of(stacks_[i], p);
                // One row more than asked for: the uppermost is given back as triangles.
                if (pass.rows > 0 && step >= pass.rows + (pass.ratio > 1 ? 1 : 0)) {
                    stacks_[i].is_running = false;
                    stacks_[i].stopped = "as many rows as asked for";
                    continue;
                }
                const RowLimits limits = limits_of(stacks_[i], p);
                // After a split the parts that can go on follow in this step.
                do {
                    stacks_[i].is_running = stacks_[i].is_running && build_row(mesh_, stacks_[i], size_, reference_, limits);
                    context_.report(static_cast<double>(p) / static_cast<double>(pass_count_));
                } while (!stacks_[i].is_running && split(i, pass));
            }
        }
    }

    /// After a source's last pass: rows that get higher quickly until they are nearly as high as wide, where there is room for
    /// them, so that the size of elements changes smoothly over the end of the rows (paper 3.2).
    void close_rows(std::size_t p) {
        for (RowStack& stack : stacks_)
            stack.is_running = p + 1 == sources_[static_cast<std::size_t>(stack.source)].passes.size() && needs_closing(stack, p);
        for (int step = 0; step < kMostClosing; ++step) {
            for (RowStack& stack : stacks_) {
                if (!stack.is_running) continue;
                RowLimits limits = limits_of(stack, p);
                limits.growth = std::max(options_.row_growth, kClosingGrowth);
                limits.height_of_width = 1.0;
                limits.over_ends = kClosingOverEnds;
                limits.free_share = kFreeClosing;
                const std::string stopped = stack.stopped;  // why the pass ended is what is told
                stack.is_running = build_row(mesh_, stack, size_, reference_, limits) && needs_closing(stack, p);
                stack.stopped = stopped;
                context_.breathe();
            }
        }
    }

    bool needs_closing(const RowStack& stack, std::size_t p) const {
        if (stack.rows() == 0 || pass_of(stack, p)->rows > 0) return false;
        double width = 0.0;
        double height = 0.0;
        for (std::size_t i = 0; i < stack.columns(); ++i) {
            width += (mesh_.position(stack.top()[i + 1]) - mesh_.position(stack.top()[i])).norm();
            height += stack.height(mesh_, i);
        }
        return width > kClosedAspect * height;
    }

    RowLimits limits_of(const RowStack& stack, std::size_t p) const {
        const auto later = static_cast<double>(sources_[static_cast<std::size_t>(stack.source)].passes.size() - p - 1);
        RowLimits limits;
        limits.pass = static_cast<int>(p) + 1;
        limits.longest_height = kLongestHeight;
        limits.growth = options_.row_growth;
        limits.height_of_width = p > 0 ? kLaterHeight : 0.0;
        limits.free_share = kFreeShare + kFreeShareLater * later;
        limits.clearance = 1.9 + kReserve * later;
        return limits;
    }

    /// Puts parts into a stack's place, where some of its columns keep all from the first few rows of a pass. (Split at every
    /// row, a stack that tapers would end in stairs: 56 % more quads on the delta wing.)
    bool split(std::size_t i, const Pass& pass) {
        if (stacks_[i].rows() >= stacks_[i].rows_before + kFewRows) return false;
        std::vector<RowStack> parts = split_stack(mesh_, stacks_[i], static_cast<std::size_t>(kLeastSegments * pass.ratio));
        if (parts.empty()) return false;
        const auto place = stacks_.erase(stacks_.begin() + static_cast<std::ptrdiff_t>(i));
        stacks_.insert(place, std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
        return true;
    }

    /// A single row would be given back after the merge: nothing but longer triangles would be left of it.
    static bool has_gained(const RowStack& stack) { return stack.rows() > stack.rows_before + 1; }

    /// Per edge of the source: 1 where the pass gave rows on a side. Elsewhere it is not merged.
    std::vector<char> gaining_edges(std::size_t s, std::size_t p) const {
        const std::vector<Vertex>& nodes = lines_[s].nodes;
        std::vector<char> gaining(nodes.size() - 1, 0);
        if (p >= sources_[s].passes.size() || sources_[s].passes[p].ratio < 2) return gaining;
        std::vector<std::int32_t> place(static_cast<std::size_t>(mesh_.vertex_slots()), -1);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            place[static_cast<std::size_t>(nodes[i].index())] = static_cast<std::int32_t>(i);
        if (!lines_[s].closed) place[static_cast<std::size_t>(nodes.back().index())] = static_cast<std::int32_t>(gaining.size());
        const auto of = [&](Vertex v) { return place[static_cast<std::size_t>(v.index())]; };
        for (const RowStack& stack : stacks_) {
            if (stack.source != static_cast<std::int32_t>(s) || !has_gained(stack)) continue;
            const std::vector<Vertex>& base = stack.layers[0];
            // On the left the nodes run along the source, on the right against it.
            for (std::size_t i = 0; i + 1 < base.size(); ++i)
                gaining[static_cast<std::size_t>(of(base[stack.left ? i : i + 1]))] = 1;
        }
        return gaining;
    }

    /// @param merged per vertex, receives 1 for the source's nodes and their neighbours: where a side has no rows, its triangles
    /// there have become slivers
    void merge_source(std::size_t s, std::size_t p, std::vector<char>& merged) {
        const std::vector<char> gaining = gaining_edges(s, p);
        if (std::find(gaining.begin(), gaining.end(), 1) == gaining.end()) return;
        Line& line = lines_[s];
        const std::vector<char> kept = segment_ends(s, sources_[s].passes[p].ratio, gaining);
        std::vector<char> is_kept(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (std::size_t i = 0; i < line.nodes.size(); ++i) is_kept[static_cast<std::size_t>(line.nodes[i].index())] = kept[i];
        std::vector<RowStack*> thinned_out;
        for (RowStack& stack : stacks_) {
            if (stack.source != static_cast<std::int32_t>(s)) continue;
            std::vector<char> kept_here;
            for (const Vertex v : stack.layers[0]) kept_here.push_back(is_kept[static_cast<std::size_t>(v.index())]);
            if (std::find(kept_here.begin(), kept_here.end(), 0) == kept_here.end()) continue;
            merge_rows(mesh_, stack, kept_here);
            thinned_out.push_back(&stack);
        }
        const int failed = merge_source_nodes(mesh_, line.nodes, kept);
        if (failed > 0) result_.warnings.push_back(std::to_string(failed) + " source nodes could not be merged");
        for (RowStack* stack : thinned_out) {
            if (stack->rows() > 0) give_back_top_row(mesh_, *stack);
        }
        // Where a stack was split, its parts share the nodes of their end columns.
        for (const RowStack& stack : stacks_) {
            for (const std::vector<Vertex>& layer : stack.layers) {
                for (const Vertex v : layer) mesh_.info(v).in_row = true;
            }
        }
        Line thinned;
        thinned.closed = line.closed;
        thinned.original = std::move(line.original);
        thinned.sharp = std::move(line.sharp);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (!kept[i]) continue;
            thinned.nodes.push_back(line.nodes[i]);
            thinned.index.push_back(line.index[i]);
        }
        line = std::move(thinned);
        merged.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (const Vertex v : line.nodes) {
            merged[static_cast<std::size_t>(v.index())] = 1;
            for (const HalfEdge h : mesh_.outgoing(v)) merged[static_cast<std::size_t>(mesh_.to(h).index())] = 1;
        }
    }

    /// A node that another line meets: it would be drawn along the source, were it merged.
    bool is_junction(Vertex v) const {
        int lines = 0;
        for (const HalfEdge h : mesh_.outgoing(v)) lines += mesh_.is_constrained(M::edge(h)) ? 1 : 0;
        return lines > 2;
    }

    /// Per vertex: 1 at the ends of rows. Their end column may run along a line, this source's or another's.
    std::vector<char> row_ends() const {
        std::vector<char> found(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (const RowStack& stack : stacks_) {
            for (std::size_t j = 1; j < stack.layers.size(); ++j) {
                for (const Vertex v : {stack.layers[j].front(), stack.layers[j].back()})
                    found[static_cast<std::size_t>(v.index())] = 1;
            }
        }
        return found;
    }

    /// Ends of stacks inside the source (where another line meets it, or a stack was split) end segments too, each part with
    /// ramps of its own; so do such nodes on a side without rows. All nodes are kept between edges that gained no rows, and
    /// where the rows of another stack end.
    std::vector<char> segment_ends(std::size_t s, int ratio, const std::vector<char>& gaining) const {
        const Line& line = lines_[s];
        const std::size_t n = line.nodes.size();
        std::vector<char> kept(n, 0);
        kept.front() = kept.back() = 1;
        bool cut = false;
        const std::vector<char> ends_row = row_ends();
        for (std::size_t i = 0; i < n; ++i) {
            if (is_junction(line.nodes[i]) || ends_row[static_cast<std::size_t>(line.nodes[i].index())] ||
                (i < gaining.size() && !gaining[i]) || (i > 0 && !gaining[i - 1])) {
                kept[i] = 1;
                cut = true;
            }
            for (const RowStack& stack : stacks_) {
                if (stack.source != static_cast<std::int32_t>(s) || stack.closed) continue;
                if (stack.layers[0].front() == line.nodes[i] || stack.layers[0].back() == line.nodes[i]) {
                    kept[i] = 1;
                    cut = true;
                }
            }
        }
        const double sagitta = kSagitta * first_row_height(s);
        for (std::size_t first = 0; first + 1 < n;) {
            std::size_t last = first + 1;
            while (!kept[last]) ++last;
            const int edges = static_cast<int>(last - first);
            const auto segments =
                line.closed && !cut
                    ? segment_closed(edges, ratio)
                    : segment_open(edges, ratio, {ramp_start(s, first, last, ratio), ramp_start(s, last, first, ratio)});
            const auto accept = [&](int a, int b) {
                const std::size_t from = first + static_cast<std::size_t>(a);
                const std::size_t to = first + static_cast<std::size_t>(b);
                const double length = (mesh_.position(line.nodes[to]) - mesh_.position(line.nodes[from])).norm();
                const double allowed =
                    has_sharp(line, from, to) ? std::min(sagitta, kFeatureSagitta * reference_.diagonal()) : sagitta;
                return deviation(line, from, to) <= allowed &&
                       free_ahead(s, line.nodes[from], line.nodes[to], kFreeAhead * length);
            };
            std::size_t at = first;
            for (const int length : refine_segments(segments, accept)) {
                at += static_cast<std::size_t>(length);
                kept[at] = 1;
            }
            first = last;
        }
        return kept;
    }

    /// Edges of the first segment of the ramp at one end of a part of the source: as few as make its column wide enough for the
    /// rows that follow, which get higher and higher.
    int ramp_start(std::size_t s, std::size_t end, std::size_t other, int ratio) const {
        const std::vector<Vertex>& nodes = lines_[s].nodes;
        double height = 0.0;
        for (const RowStack& stack : stacks_) {
            if (stack.source != static_cast<std::int32_t>(s) || stack.closed) continue;
            if (stack.layers[0].front() == nodes[end]) height = std::max(height, stack.height(mesh_, 0));
            if (stack.layers[0].back() == nodes[end]) height = std::max(height, stack.height(mesh_, stack.columns()));
        }
        int n = 1;
        for (std::size_t i = end; n < ratio; ++n) {
            i = end < other ? i + 1 : i - 1;
            if (i == other || (mesh_.position(nodes[i]) - mesh_.position(nodes[end])).norm() >= kColumnAtEnd * height) break;
        }
        return n;
    }

    /// Smallest height of the rows next to the source, which a merged edge must not cut off.
    double first_row_height(std::size_t s) const {
        double height = 1e300;
        for (const RowStack& stack : stacks_) {
            if (stack.source != static_cast<std::int32_t>(s) || stack.rows() == 0) continue;
            for (std::size_t i = 0; i < stack.layers[0].size(); ++i) {
                height = std::min(height, (mesh_.position(stack.layers[1][i]) - mesh_.position(stack.layers[0][i])).norm());
            }
        }
        return height;
    }

    /// True if the rows over the segment have at least `way` of unmeshed surface ahead, which turns so little on it that squares
    /// of that size follow it: longer edges could not lead over to what follows them.
    bool free_ahead(std::size_t s, Vertex from, Vertex to, double way) const {
        for (const RowStack& stack : stacks_) {
            if (stack.source != static_cast<std::int32_t>(s) || stack.rows() == 0) continue;
            const auto& nodes = stack.layers[0];
            for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
                if (nodes[i] != from && nodes[i] != to) continue;
                const HalfEdge in = mesh_.find_halfedge(stack.top()[i - 1], stack.top()[i]);
                if (!in.is_valid() || !is_front(mesh_, in)) continue;
                const TraceEnd end = trace_geodesic(mesh_, in, 0.5 * front_angle(mesh_, in), way);
                if (end.blocked && end.incidence > 0.6) return false;
                const Point middle = 0.5 * (mesh_.position(stack.top()[i]) + end.position);
                if (reference_.closest(middle).distance > kAheadSagitta * reference_.diagonal()) return false;
            }
        }
        return true;
    }

    bool is_sharp(HalfEdge h) const {
        if (mesh_.is_boundary(M::edge(h))) return true;
        const Eigen::Vector3d left = doubled_area_vector(mesh_, mesh_.face(h));
        const Eigen::Vector3d right = doubled_area_vector(mesh_, mesh_.face(M::twin(h)));
        return std::atan2(left.cross(right).norm(), left.dot(right)) > options_.feature_angle * std::numbers::pi / 180.0;
    }

    static bool has_sharp(const Line& line, std::size_t a, std::size_t b) {
        const auto at = [&](std::size_t i) { return line.sharp.begin() + static_cast<std::ptrdiff_t>(line.index[i]); };
        return std::find(at(a), at(b), 1) != at(b);
    }

    /// Largest distance of the picked polyline between two nodes from the straight edge that is to replace it.
    static double deviation(const Line& line, std::size_t a, std::size_t b) {
        const Point& p = line.original[line.index[a]];
        const Point& q = line.original[line.index[b]];
        const Eigen::Vector3d along = (q - p).normalized();
        double largest = 0.0;
        for (std::size_t i = line.index[a] + 1; i < line.index[b]; ++i) {
            const Eigen::Vector3d offset = line.original[i] - p;
            largest = std::max(largest, (offset - offset.dot(along) * along).norm());
        }
        return largest;
    }

    SurfaceMesh& mesh_;
    std::span<const Source> sources_;
    const LocalSize& size_;
    const ReferenceSurface& reference_;
    const Options& options_;
    const StageObserver& observe_;
    Context& context_;
    std::vector<RowStack> stacks_;
    std::vector<Line> lines_;
    std::size_t pass_count_ = 0;
    MultiPassResult result_;
};

}  // namespace

MultiPassResult build_anisotropic_rows(SurfaceMesh& mesh, std::span<const Source> sources, const LocalSize& size,
                                       const ReferenceSurface& reference, const Options& options, const StageObserver& observe,
                                       Context& context) {
    return MultiPass(mesh, sources, size, reference, options, observe, context).run();
}

}  // namespace anisoquad
