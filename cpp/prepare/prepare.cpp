#include "prepare/prepare.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "mesh/area_vector.h"
#include "prepare/assess.h"
#include "prepare/line_nodes.h"
#include "prepare/remesh.h"
#include "prepare/size_field.h"
#include "prepare/size_range.h"
#include "prepare/source_spacing.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr int kSweeps = 12;
constexpr int kLeastSweeps = 4;
constexpr double kAtRest = 0.01;         ///< of the triangles that change in a sweep: below it, it is the last one
constexpr double kLineSagitta = 5e-5;    ///< of line edges off the input's line, over the model's diagonal
constexpr double kRidgeSagitta = 2e-4;   ///< of the edges of ridges
constexpr double kSagitta = 4e-4;        ///< of edges off the surface, over the model's diagonal
constexpr double kCoarseSagitta = 2e-3;  ///< of quads made of the triangles as they are, over the model's diagonal
constexpr double kSagittaAsked = 0.1;    ///< the same over the wanted size, where one is asked for
constexpr double kUncovered =
    1.25;  ///< bound for the surface's points off the triangles, over that of the triangles off the surface
constexpr double kMostTriangles = 6.0;    ///< that may be made of one, where no size is asked for
constexpr double kFewTriangles = 6000.0;  ///< that may be made in any case
constexpr double kMostOfWanted = 4.0;     ///< triangles over those that the sizes ask for, beyond which no edge is split
constexpr double kPerLineEdge = 4.0;      ///< triangles that an edge of a line may ask for, however narrow the surface is
constexpr double kAlongSource = 2.0;      ///< wanted length of merged edges over the largest size
constexpr double kMostRefinement = 8.0;   ///< of the edges along a source
constexpr double kWidthOverHeight =
    1.5;  ///< of the columns along a source, before any merge, over the height of rows at its ends
constexpr double kFinestSource = 1.0 / 64.0;  ///< least edges along a source for the rows at its ends, over the largest size
constexpr double kStepAtLine = 1.8;  ///< line edges this much longer than wanted spread the remeshing to the patch behind them

bool is_asked(const Options& options) { return options.size > 0.0 || !options.vertex_size.empty(); }

bool is_to_remesh(const PatchAssessment& patch, const Options& options) {
    return is_asked(options) || (options.prepare && (patch.is_poor || patch.is_graded || patch.is_coarse));
}

class Prepare {
  public:
    Prepare(SurfaceMesh& mesh, const PrepareInput& input, std::vector<Source>& sources, const Options& options, Context& context)
        : mesh_(mesh), input_(input), sources_(sources), options_(options), context_(context) {}

    PrepareResult run() {
        result_.triangles_before = result_.triangles_after = mesh_.face_count();
        choose_patches();
        if (std::find(chosen_.begin(), chosen_.end(), 1) == chosen_.end()) return result_;
        SizeField field = make_field();
        coverage_.emplace(mesh_, range_.smallest, kUncovered * sagitta_);
        chains_ = line_nodes(mesh_, input_.lines, input_.reference_lines);
        bound_sources();
        spread(field);
        result_.patches = static_cast<std::int32_t>(std::count(chosen_.begin(), chosen_.end(), 1));
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            context_.report(static_cast<double>(sweep) / kSweeps);
            // Lines first, as often as they still double: the triangles beside them follow.
            for (int i = 0; i < kSweeps; ++i) {
                field.assign(mesh_, hint_, kept_edges(), vertex_bounds(), context_);
                if (redistribute_lines() == 0 || sweep > 0) break;
            }
            if (sweep == 0) bound_by_shape();
            // Where a line's shape asks for shorter edges than the field, the triangles beside it grow from these.
            const std::vector<char> lines = line_edges();
            field.assign(mesh_, hint_, lines, vertex_bounds(), context_);
            std::vector<char> zone = zone_of_patches();
            const RemeshResult r = remesh_triangles(mesh_, zone, input_.reference,
                                                    {.sweeps = 1,
                                                     .deviation = sagitta_ / input_.reference.diagonal(),
                                                     .patches = chosen_,
                                                     .coverage = &*coverage_,
                                                     .most_triangles = most_triangles(lines),
                                                     .context = &context_});
            if (sweep + 1 >= kLeastSweeps && r.splits + r.collapses < kAtRest * mesh_.face_count()) break;
        }
        follow_sources();
        result_.triangles_after = mesh_.face_count();
        return result_;
    }

  private:
    void choose_patches() {
        const double most_sagitta =
            input_.has_target ? std::numeric_limits<double>::max() : kCoarseSagitta * input_.reference.diagonal();
        for (const PatchAssessment& patch : assess_patches(mesh_, options_.curvature_angle, most_sagitta)) {
            chosen_.push_back(is_to_remesh(patch, options_) ? 1 : 0);
            if (!chosen_.back()) continue;
            result_.poor += patch.is_poor;
            result_.graded += patch.is_graded && !patch.is_poor;
            result_.coarse += patch.is_coarse && !patch.is_graded && !patch.is_poor;
            result_.poor_triangles += patch.poor;
        }
    }

    SizeField make_field() {
        const double diagonal = input_.reference.diagonal();
        range_ = size_range(input_.points, input_.triangles, diagonal, input_.unit, options_);
        SizeFieldOptions options;
        options.largest = range_.largest;
        options.smallest = range_.smallest;
        for (const double size : options_.vertex_size) vertex_size_.push_back(size / input_.unit);
        options.vertex_size = vertex_size_;
        options.curvature_angle = options_.curvature_angle;
        // A wanted size may cut more off the surface than one of our own choice.
        sagitta_ = std::max(kSagitta * diagonal, is_asked(options_) ? kSagittaAsked * range_.largest : 0.0);
        options.sagitta = sagitta_;
        options.growth = options_.growth;
        options.in_fold = input_.in_fold;
        SizeField field(input_.points, input_.triangles, input_.reference, options);
        if (!is_asked(options_)) {
            // A size of our own choice must not make a mesh far larger than the input.
            const double most = kMostTriangles * static_cast<double>(input_.triangles.size()) + kFewTriangles;
            const double factor = field.coarsen_to(most, input_.points, input_.triangles);
            range_.largest *= factor;
            range_.smallest *= factor;
        }
        result_.size = range_.largest * input_.unit;
        refine_at_sources(field, range_.largest);
        return field;
    }

    /// Rows are merged along their source: its edges must be short before, so that they are not too long afterwards.
    void refine_at_sources(SizeField& field, double largest) const {
        for (const Source& source : sources_) {
            double anisotropy = 1.0;
            for (const Pass& pass : source.passes) anisotropy *= pass.ratio;
            const double size = largest * std::min(1.0, kAlongSource / std::min(anisotropy, kMostRefinement * kAlongSource));
            for (const std::int32_t v : source.vertices) {
                for (const HalfEdge h : mesh_.outgoing(Vertex(v))) {
                    if (!mesh_.is_boundary(h)) field.limit(mesh_.face(h).index(), size);
                }
            }
        }
    }

    bool is_source(const LineNodes& chain) const {
        const std::int32_t s = input_.lines[static_cast<std::size_t>(chain.line)].source;
        return s >= 0 && !sources_[static_cast<std::size_t>(s)].passes.empty();
    }

    /// Edges along sources suit the height that the rows can have at the ends.
    void bound_sources() {
        if (std::none_of(chains_.begin(), chains_.end(), [&](const LineNodes& chain) { return is_source(chain); })) return;
        const SourceSpacingOptions options{range_.largest, kFinestSource * range_.largest,
                                           kLineSagitta * input_.reference.diagonal()};
        for (std::size_t s = 0; s < sources_.size(); ++s) {
            source_bound_.push_back(kWidthOverHeight * source_spacing(mesh_, chains_, input_.lines, input_.reference_lines,
                                                                      static_cast<std::int32_t>(s), options));
        }
    }

    double line_deviation(const LineNodes& chain) const {
        const bool is_ridge = input_.lines[static_cast<std::size_t>(chain.line)].is_ridge;
        return (is_ridge ? kRidgeSagitta : kLineSagitta) * input_.reference.diagonal();
    }

    /// Edges that the shape of one of the input's lines keeps short: other lines that meet it there grow from them. To be asked
    /// once, when the lines are as coarse as they can be: what is split later for their sake must not ask for more.
    void bound_by_shape() {
        shape_bound_.assign(static_cast<std::size_t>(mesh_.vertex_slots()), 0.0);
        for (const LineNodes& chain : chains_) {
            if (!input_.lines[static_cast<std::size_t>(chain.line)].is_ridge) bound_by_shape(chain);
        }
    }

    void bound_by_shape(const LineNodes& chain) {
        const double deviation = line_deviation(chain);
        for (std::size_t i = 1; i + 1 < chain.nodes.size(); ++i) {
            if (input_.reference_lines.deviation(chain.line, chain.ways[i - 1], chain.ways[i + 1]) <= deviation) continue;
            const double length = 0.5 * (chain.ways[i + 1] - chain.ways[i - 1]);
            for (std::size_t k = i - 1; k <= i + 1; ++k) bound(shape_bound_, chain.nodes[k], length);
        }
    }

    static void bound(std::vector<double>& bounds, Vertex v, double size) {
        double& kept = bounds[static_cast<std::size_t>(v.index())];
        kept = kept > 0.0 ? std::min(kept, size) : size;
    }

    /// Per vertex: bound of the size for the shape of lines, and on sources with rows; 0 = none.
    std::vector<double> vertex_bounds() const {
        std::vector<double> bounds = shape_bound_;
        bounds.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0.0);
        if (source_bound_.empty()) return bounds;
        for (const LineNodes& chain : chains_) {
            if (!is_source(chain)) continue;
            const std::int32_t source = input_.lines[static_cast<std::size_t>(chain.line)].source;
            for (const Vertex v : chain.nodes) bound(bounds, v, source_bound_[static_cast<std::size_t>(source)]);
        }
        return bounds;
    }

    bool is_chosen(HalfEdge h) const {
        return !mesh_.is_boundary(h) && chosen_[static_cast<std::size_t>(mesh_.info(mesh_.face(h)).patch)] != 0;
    }
    bool is_settled(HalfEdge h) const { return !mesh_.is_boundary(h) && !is_chosen(h); }

    /// Per edge: 1 for edges of lines that a patch shares which is not remeshed.
    std::vector<char> kept_edges() const {
        std::vector<char> kept(static_cast<std::size_t>(mesh_.edge_slots()), 0);
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            const Edge e(i);
            if (mesh_.is_deleted(e)) continue;
            kept[static_cast<std::size_t>(i)] = is_settled(M::halfedge(e, 0)) || is_settled(M::halfedge(e, 1));
        }
        return kept;
    }

    /// Per edge: 1 for edges of lines.
    std::vector<char> line_edges() const {
        std::vector<char> edges(static_cast<std::size_t>(mesh_.edge_slots()), 0);
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            const Edge e(i);
            edges[static_cast<std::size_t>(i)] = !mesh_.is_deleted(e) && (mesh_.is_boundary(e) || mesh_.info(e).line >= 0);
        }
        return edges;
    }

    /// Patches with long edges beside a patch that wants far shorter ones are remeshed too.
    void spread(const SizeField& field) {
        for (bool again = true; again;) {
            again = false;
            // Every patch decides freely here, so that its lines show what they would like to be.
            field.assign(mesh_, hint_, {}, {}, context_);
            for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
                const Edge e(i);
                if (mesh_.is_deleted(e) || mesh_.is_boundary(e) || mesh_.info(e).line < 0) continue;
                const HalfEdge h = M::halfedge(e);
                const HalfEdge settled = is_chosen(h) ? M::twin(h) : h;
                if (is_chosen(settled) || !is_chosen(M::twin(settled))) continue;
                const double wanted = 0.5 * (mesh_.info(mesh_.from(h)).size + mesh_.info(mesh_.to(h)).size);
                if (mesh_.length(e) < kStepAtLine * wanted) continue;
                chosen_[static_cast<std::size_t>(mesh_.info(mesh_.face(settled)).patch)] = 1;
                again = true;
            }
        }
    }

    std::int32_t redistribute_lines() {
        std::int32_t changes = 0;
        for (LineNodes& chain : chains_) {
            bool free = true;
            for (std::size_t i = 0; i + 1 < chain.nodes.size() && free; ++i) {
                const HalfEdge h = mesh_.find_halfedge(chain.nodes[i], chain.nodes[i + 1]);
                free = !is_settled(h) && !is_settled(M::twin(h));
            }
            if (!free) continue;
            changes += redistribute_line_nodes(mesh_, chain, input_.reference_lines, input_.reference,
                                               {line_deviation(chain), sagitta_, &*coverage_, is_source(chain)});
        }
        return changes;
    }

    /// A limit on work: between slivers that can neither be swapped nor collapsed, splits would go on and on.
    /// @param lines per edge: 1 for edges of lines
    std::int32_t most_triangles(const std::vector<char>& lines) const {
        double wanted = 0.0;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            const Face f(i);
            if (mesh_.is_deleted(f)) continue;
            double size = 0.0;
            for (const HalfEdge h : mesh_.halfedges(f)) size += mesh_.info(mesh_.from(h)).size / 3.0;
            // An equilateral triangle of that edge.
            wanted += doubled_area_vector(mesh_, f).norm() / (0.5 * std::numbers::sqrt3 * size * size);
        }
        wanted += kPerLineEdge * static_cast<double>(std::count(lines.begin(), lines.end(), 1));
        const double most = kMostOfWanted * wanted + kFewTriangles;
        constexpr auto kAny = std::numeric_limits<std::int32_t>::max();
        return most < kAny ? static_cast<std::int32_t>(most) : kAny;
    }

    /// Nodes of the chosen patches, and of the lines round them.
    std::vector<char> zone_of_patches() const {
        std::vector<char> zone(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (std::int32_t i = 0; i < mesh_.halfedge_slots(); ++i) {
            const HalfEdge h(i);
            if (!mesh_.is_deleted(h) && is_chosen(h)) zone[static_cast<std::size_t>(mesh_.from(h).index())] = 1;
        }
        return zone;
    }

    void follow_sources() {
        for (std::size_t s = 0; s < sources_.size(); ++s) {
            std::vector<std::int32_t> nodes;
            for (const LineNodes& chain : chains_) {
                if (input_.lines[static_cast<std::size_t>(chain.line)].source != static_cast<std::int32_t>(s)) continue;
                for (const Vertex v : chain.nodes) {
                    if (nodes.empty() || nodes.back() != v.index()) nodes.push_back(v.index());
                }
            }
            sources_[s].vertices = std::move(nodes);
        }
    }

    SurfaceMesh& mesh_;
    const PrepareInput& input_;
    std::vector<Source>& sources_;
    const Options& options_;
    Context& context_;
    PrepareResult result_;
    std::vector<char> chosen_;
    SizeRange range_;
    double sagitta_ = 0.0;
    std::optional<Coverage> coverage_;
    std::vector<LineNodes> chains_;
    std::vector<std::int32_t> hint_;
    std::vector<double> vertex_size_;
    std::vector<double> shape_bound_;   ///< per vertex, where a line's shape keeps its edges short; 0 = none
    std::vector<double> source_bound_;  ///< per source, of the edges along it; empty: no source has rows
};

}  // namespace

std::vector<char> patches_to_remesh(const SurfaceMesh& mesh, const Options& options, double diagonal) {
    std::vector<char> chosen;
    for (const PatchAssessment& patch : assess_patches(mesh, options.curvature_angle, kCoarseSagitta * diagonal))
        chosen.push_back(is_to_remesh(patch, options) ? 1 : 0);
    return chosen;
}

PrepareResult prepare_triangles(SurfaceMesh& mesh, const PrepareInput& input, std::vector<Source>& sources,
                                const Options& options, Context& context) {
    return Prepare(mesh, input, sources, options, context).run();
}

}  // namespace anisoquad
