#include "quad_mesh.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <sstream>

#include "anisotropy/blend_ahead.h"
#include "anisotropy/local_size.h"
#include "anisotropy/multi_pass.h"
#include "cleanup/cleanup.h"
#include "cleanup/onto_tips.h"
#include "features/feature_lines.h"
#include "features/parity.h"
#include "features/patches.h"
#include "features/reference_lines.h"
#include "features/ridges.h"
#include "features/small_patches.h"
#include "features/tips.h"
#include "input/check.h"
#include "input/needles.h"
#include "input/open_doubles.h"
#include "input/repair.h"
#include "input/slivers.h"
#include "input/working_input.h"
#include "mesh/arrays.h"
#include "mesh/validate.h"
#include "parallel.h"
#include "parts/in_parts.h"
#include "parts/partition.h"
#include "prepare/prepare.h"
#include "prepare/size_range.h"
#include "qmorph/front.h"
#include "qmorph/node_size.h"
#include "qmorph/qmorph.h"
#include "quality/measure.h"
#include "result/collect_result.h"
#include "result/nearest_input.h"
#include "result/stage_snapshot.h"
#include "smoothing/final_smoothing.h"
#include "smoothing/onto_target.h"
#include "surface/reference_surface.h"

namespace anisoquad {
namespace {

using Triangles = std::span<const std::array<std::int32_t, 3>>;

// Shares of the whole run that are done after a stage.
constexpr double kPrepared = 0.26;
constexpr double kFilledInParts = 0.65;
constexpr double kFilled = 0.7;
constexpr double kCleanedInParts = 0.78;
constexpr double kCleaned = 0.8;
constexpr int kRepairRounds = 2;
constexpr int kMostInverted = 400;  ///< of a surface that folds over itself, say: more is beyond repair, and would take long
constexpr double kFoldWidth = 0.6;  ///< of what counts as a fold, over the largest size

/// Six digits, whatever the unit.
std::string length_text(double length) {
    std::ostringstream text;
    text << length;
    return text.str();
}

/// The stages of one run, in order.
class Pipeline {
  public:
    Pipeline(std::span<const Point> points, Triangles triangles, std::span<const Source> sources, const Options& options,
             Context& context, const TargetSurface* target = nullptr)
        : points_(points),
          triangles_(triangles),
          sources_(sources.begin(), sources.end()),
          options_(options),
          context_(context),
          target_(target) {}

    QuadMeshResult run() {
        begin("check", 0.0, 0.02);
        check_options(options_, points_.size());
        check_input(points_, triangles_, context_);
        context_.report(0.25);
        input_.emplace(points_, triangles_, target_ != nullptr, context_);
        context_.report(0.5);
        mesh_ = from_arrays(input_->points(), input_->triangles(), context_);
        context_.breathe();
        check_sources(mesh_, sources_, input_->rank());
        check_feature_edges(mesh_, options_.feature_edges, input_->rank());
        context_.report(0.75);
        input_->put_in_order(sources_, options_);
        if (!options_.repair && !target_) look_for_cracks();
        if (!target_) mend_thin_triangles();
        context_.breathe();
        before_ = topology(mesh_);
        end();

        begin("features", 0.02, 0.05);
        std::vector<char> in_fold;
        const std::vector<FeatureLine> lines = find_lines(in_fold);
        context_.report(0.3);
        const ReferenceLines reference_lines(mesh_, lines);
        tips_ = find_tips(mesh_);
        report().feature_lines = static_cast<std::int32_t>(lines.size());
        std::vector<std::int32_t> facet_patch;
        for (std::int32_t f = 0; f < mesh_.face_slots(); ++f) facet_patch.push_back(mesh_.info(Face(f)).patch);
        ReferenceSurface reference(input_->points(), input_->triangles(), facet_patch, options_.feature_angle, context_);
        end();

        begin("prepare", 0.05, 0.1);
        std::vector<Source> sources = sources_;
        const bool remeshed = prepare(sources, {input_->points(), input_->triangles(), reference, lines, reference_lines,
                                                input_->scale(), in_fold, target_ != nullptr});
        end();
        if (remeshed) snapshot("prepare");

        begin("rows", 0.1, 0.25);
        assign_node_sizes(mesh_);
        build_rows(sources, reference, remeshed);
        input_->release_arrays();  // from here on the reference surface knows them
        end();

        begin("parity", 0.25, kPrepared);
        report().parity_splits = refine_small_patches(mesh_);
        context_.breathe();
        const ParityResult parity = make_parity_even(mesh_);
        report().parity_splits += parity.splits;
        if (!parity.left.empty())
            warn(std::to_string(parity.left.size()) + " patches have an odd boundary that nothing can make even");
        end();

        begin("fill", kPrepared, kFilled);
        fill(reference);
        end();
        snapshot("fill");

        begin("clean-up", kFilled, kCleaned);
        if (options_.cleanup) clean_up_parts(reference);
        end();

        begin("smoothing", kCleaned, 0.95);
        if (target_) {
            reference.set_target({target_, input_->centre(), input_->scale()});
            move_onto_target(mesh_, reference, reference_lines);
        }
        smooth_and_repair(reference, reference_lines);
        if (target_) settle_on_target(reference, reference_lines);
        end();
        snapshot("result");

        begin("report", 0.95, 1.0);
        finish(reference);
        if (target_) find_nearest_input(mesh_, reference, reference_lines, result_);
        end();
        return std::move(result_);
    }

  private:
    Report& report() { return result_.report; }
    void warn(const std::string& text) { report().warnings.push_back(text); }

    void begin(const char* stage, double from, double to) {
        stage_ = stage;
        started_ = std::chrono::steady_clock::now();
        context_.begin_stage(stage, from, to);
    }

    void end() {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - started_;
        report().times.push_back({stage_, time.count()});
#ifdef ANISOQUAD_VALIDATE
        check_invariants();
#else
        if (options_.validate) check_invariants();
#endif
    }

    void look_for_cracks() {
        const std::int32_t doubles = count_open_doubles(mesh_);
        if (doubles == 0) return;
        warn(std::to_string(doubles) +
             " vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it");
    }

    void mend_thin_triangles() {
        const int collapsed = input_->collapse_needles_of(mesh_, sources_, options_, context_);
        if (collapsed > 0) {
            warn(std::to_string(collapsed) + " edges were collapsed because they are shorter than " + length_text(kNeedleLength) +
                 " of the diagonal");
        }
        const std::size_t changed = input_->turn_slivers_of(mesh_, sources_, options_);
        if (changed == 0) return;
        warn("the edges of " + std::to_string(changed) + " triangles were turned because some were thinner than " +
             length_text(kSliverHeight) + " of the diagonal");
    }

    /// The invariants of every stage; a violation is an error of ours, not of the user.
    void check_invariants() const {
        if (mesh_.face_slots() == 0) return;
        const std::vector<std::string> defects = validate(mesh_);
        if (!defects.empty()) throw std::logic_error("invalid mesh after stage '" + stage_ + "': " + defects.front());
        if (topology(mesh_) != before_) throw std::logic_error("the topology changed in stage '" + stage_ + "'");
    }

    /// Feature lines and patches. Where triangles are to be remeshed, folds that would be lost become lines too.
    std::vector<FeatureLine> find_lines(std::vector<char>& in_fold) {
        std::vector<FeatureLine> lines = find_features(mesh_, sources_, options_);
        context_.breathe();
        report().patches = find_patches(mesh_);
        context_.breathe();
        if (target_) return lines;  // a CAD shape has borders of its faces there
        const std::vector<char> chosen = patches_to_remesh(mesh_, options_, 1.0);
        if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end()) return lines;
        const SizeRange range = size_range(input_->points(), input_->triangles(), 1.0, input_->scale(), options_);
        Ridges ridges = find_ridges(mesh_, chosen, {.width = kFoldWidth * range.largest});
        in_fold = std::move(ridges.in_fold);
        if (ridges.edges.empty()) return lines;
        lines = find_features(mesh_, sources_, options_, ridges.edges);
        report().patches = find_patches(mesh_);
        return lines;
    }

    /// @returns true if triangles were remeshed
    bool prepare(std::vector<Source>& sources, const PrepareInput& input) {
        const PrepareResult prepared = prepare_triangles(mesh_, input, sources, options_, context_);
        if (prepared.patches == 0) return false;
        std::string why;
        if (prepared.poor > 0) {
            why += "; " + std::to_string(prepared.poor) + " of them have triangles too long and thin for quads (" +
                   std::to_string(prepared.poor_triangles) + " triangles)";
        }
        if (prepared.graded > 0)
            why += "; in " + std::to_string(prepared.graded) + " of them the triangles' size changes too fast";
        if (prepared.coarse > 0)
            why += "; in " + std::to_string(prepared.coarse) + " of them the triangles turn too far from one to the next";
        warn(std::to_string(prepared.patches) + " patches were remeshed before: " + std::to_string(prepared.triangles_before) +
             " triangles became " + std::to_string(prepared.triangles_after) + ", edges up to " + length_text(prepared.size) +
             why);
        return true;
    }

    void build_rows(std::span<const Source> sources, const ReferenceSurface& reference, bool remeshed) {
        if (std::all_of(sources.begin(), sources.end(), [](const Source& s) { return s.passes.empty(); })) return;
        // Sizes are those of the triangles in use.
        std::vector<Point> points;
        std::vector<std::array<std::int32_t, 3>> triangles;
        ReferenceSurface in_use;
        if (remeshed) {
            MeshArrays arrays = to_arrays(mesh_);
            points = std::move(arrays.points);
            for (const auto& f : arrays.faces) triangles.push_back({f[0], f[1], f[2]});
            in_use = ReferenceSurface(points, triangles, {}, options_.feature_angle, context_);
        }
        const LocalSize size =
            remeshed ? LocalSize(points, triangles, in_use) : LocalSize(input_->points(), input_->triangles(), reference);
        const auto observe = [&](const std::string& stage) {
#ifdef ANISOQUAD_VALIDATE
            stage_ = stage;
            if (stage.ends_with("merge")) check_invariants();
#endif
            snapshot(stage);
        };
        MultiPassResult rows = build_anisotropic_rows(mesh_, sources, size, reference, options_, observe, context_);
        report().passes = std::move(rows.passes);
        for (const std::string& warning : rows.warnings) warn(warning);
        assign_node_sizes(mesh_);
        blend_ahead_of_rows(mesh_, reference, context_);
    }

    /// Parts of a large mesh side by side; what waits near the cuts is filled from both sides afterwards.
    void fill(const ReferenceSurface& reference) {
        const Partition partition = make_partition(
            mesh_, [&](Face f) { return touches_front(mesh_, f); }, context_);
        if (!partition.all_cuts.empty()) context_.begin_stage("fill", kPrepared, kFilledInParts);
        std::atomic<std::int32_t> left = 0;
        in_parts(mesh_, partition, context_, [&](SurfaceMesh& part, const Cuts& cuts, Context& own) {
            left += fill_with_quads(part, &reference, own, cuts).left;
        });
        if (!partition.all_cuts.empty()) {
            context_.begin_stage("fill", kFilledInParts, kFilled);
            left = fill_with_quads(mesh_, &reference, context_).left;
        }
        if (left > 0) warn(std::to_string(left) + " triangles are left");
    }

    /// The same for the clean-up.
    void clean_up_parts(const ReferenceSurface& reference) {
        const Partition partition = make_partition(
            mesh_, [](Face) { return true; }, context_);
        if (!partition.all_cuts.empty()) context_.begin_stage("clean-up", kFilled, kCleanedInParts);
        in_parts(mesh_, partition, context_,
                 [&](SurfaceMesh& part, const Cuts&, Context& own) { clean_up(part, reference, own); });
        if (partition.all_cuts.empty()) return;
        context_.begin_stage("clean-up", kCleanedInParts, kCleaned);
        clean_up_near(partition.all_cuts, mesh_, reference, context_);
    }

    /// Smoothing makes room for replacements that the clean-up had to take back: where it leaves quads inverted, both in turn as
    /// long as that helps.
    void smooth_and_repair(const ReferenceSurface& reference, const ReferenceLines& lines) {
        int inverted = mesh_.face_slots();
        for (int round = 0;; ++round) {
            move_onto_tips(mesh_, reference, tips_);
            const FinalSmoothingResult result = smooth_mesh(mesh_, reference, options_, context_, lines);
            if (result.inverted == 0 || result.inverted >= inverted || !options_.cleanup || round == kRepairRounds) return;
            if (result.inverted > kMostInverted) return;
            inverted = result.inverted;
            if (clean_up(mesh_, reference, context_).operations == 0) return;
        }
    }

    /// What slid along the input's lines in the smoothing is brought onto the target once more.
    void settle_on_target(const ReferenceSurface& reference, const ReferenceLines& lines) {
        const OntoTargetResult result = move_onto_target(mesh_, reference, lines);
        if (result.inverted > 0)
            warn(std::to_string(result.inverted) + " quads are turned over by the surface to which they were brought");
    }

    void snapshot(const std::string& name) {
        if (options_.record_stages) result_.stages.push_back(snapshot_of(mesh_, *input_, name));
    }

    void finish(const ReferenceSurface& reference) {
        measure(mesh_, reference, before_.euler_characteristic, report(), sources_, context_);
        report().hausdorff *= input_->scale();
        for (RowReport& row : report().rows) row.height_mean *= input_->scale();
        collect_result(mesh_, *input_, result_);
    }

    std::span<const Point> points_;  ///< as the user gave them
    Triangles triangles_;
    std::vector<Source> sources_;
    Options options_;
    Context& context_;
    const TargetSurface* target_;
    std::optional<WorkingInput> input_;  ///< once the checks have passed
    SurfaceMesh mesh_;
    std::vector<Tip> tips_;
    Topology before_;
    QuadMeshResult result_;
    std::string stage_;
    std::chrono::steady_clock::time_point started_;
};

/// The whole way for a mended surface. Ids in the result are those of the input.
QuadMeshResult mesh_repaired(std::span<const Point> points, Triangles triangles, std::span<const Source> sources, Options options,
                             Context& context) {
    context.begin_stage("repair", 0.0, 0.01);
    const RepairResult repaired = repair_surface(points, triangles, sources, options.feature_edges);
    options.feature_edges = repaired.feature_edges;
    if (options.vertex_size.size() == points.size() && !points.empty()) {
        // Vertices that the repair adds stand at an input vertex, or on an edge, where the smallest size does no harm.
        const double least = *std::min_element(options.vertex_size.begin(), options.vertex_size.end());
        for (std::size_t i = points.size(); i < repaired.points.size(); ++i) {
            const std::int32_t origin = repaired.origin[i];
            options.vertex_size.push_back(origin >= 0 ? options.vertex_size[static_cast<std::size_t>(origin)] : least);
        }
    }
    QuadMeshResult result = Pipeline(repaired.points, repaired.triangles, repaired.sources, options, context).run();
    for (std::int32_t& input : result.node_input) input = input >= 0 ? repaired.origin[static_cast<std::size_t>(input)] : -1;
    result.report.repair = repaired.report;
    const std::string changed = summary(repaired.report);
    if (!changed.empty()) result.report.warnings.insert(result.report.warnings.begin(), "the input was repaired: " + changed);
    return result;
}

}  // namespace

QuadMeshResult quad_mesh(std::span<const Point> points, Triangles triangles, std::span<const Source> sources,
                         const Options& options, Context& context, const TargetSurface* target) {
    // The target knows the triangles by their ids, which a repair changes.
    if (options.repair && target)
        throw Error(ErrorCode::invalid_option,
                    "The triangles of a CAD shape can't be repaired: mend the shape, or mesh without it.");
    check_options(options, points.size());
    return with_threads(options.threads, [&] {
        if (options.repair) return mesh_repaired(points, triangles, sources, options, context);
        return Pipeline(points, triangles, sources, options, context, target).run();
    });
}

}  // namespace anisoquad
