#include "cleanup/cleanup.h"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>
#include <vector>

#include "cleanup/patterns.h"
#include "cleanup/region_growth.h"
#include "cleanup/trial.h"
#include "mesh/area_vector.h"
#include "mesh/face_middle.h"
#include "parallel.h"
#include "quality/metrics.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr int kRounds = 4;                ///< in which regions grow from all nodes round which something changed
constexpr std::size_t kTriesPerNode = 3;  ///< replacements tried per irregular node: none takes forever on a hopeless mesh
constexpr std::size_t kLeastTries = 200;
constexpr std::size_t kWorkPerQuad = 60;  ///< quads that are judged in all tries together, per quad of the mesh
constexpr std::size_t kLeastWork = 2000;
constexpr std::size_t kTriesPerPoor = 50;  ///< the same for the repair of poor quads
constexpr std::size_t kWorkPerPoor = 1000;
constexpr std::size_t kMostPoor = 40;  ///< quads for which there are such tries: a mesh with more is hopeless for other reasons
constexpr double kPoor = 0.35;         ///< scaled Jacobian of quads that are repaired even if no irregularity is gained
constexpr Trial::Demands kRepair{0, 0.4, 0.1};
constexpr double kUnusable = 0.05;  ///< scaled Jacobian of quads that are repaired at the price of irregular nodes
constexpr Trial::Demands kRepairAtAnyPrice{-20, 0.4, 0.01, 6.0};
constexpr Trial::Demands kFold{-20, 0.4, 0.01, 6.0, 0.0, 1.0, true, true};  ///< within hair-thin triangles nothing lies flat
constexpr double kThorough = 0.8;  ///< share of what a quad lacks to be usable that its repair should make good
constexpr double kSlim = 0.3;  ///< scaled Jacobian of quads that are worth a few irregular nodes if those make them much better
constexpr Trial::Demands kRepairAtAPrice{-8, 0.4, 0.1, 6.0};
constexpr double kFar = 1.2e-3;  ///< distance from the surface, over its diagonal, of quads that are repaired
constexpr double kBent = 0.9;    ///< cosine of the turn to a neighbour below which quads may be far
constexpr Trial::Demands kBringNearer{-12, 0.25, 0.0, 6.0, 0.0, 0.7};
constexpr int kRepairRounds = 3;
constexpr double kNearCut = 12.0;  ///< over the length of an edge: where regions could not grow in the parts

std::int32_t irregular_nodes(const SurfaceMesh& mesh) {
    std::int32_t n = 0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (!mesh.is_deleted(v) && !mesh.is_boundary(v) && mesh.valence(v) != 4) ++n;
    }
    return n;
}

/// Works off the irregular nodes and what changes near them.
class Cleaner {
  public:
    Cleaner(SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context)
        : mesh_(mesh), reference_(reference), context_(context), trial_(mesh, reference), growth_(trial_, planner_) {}

    /// @param cuts where there are any, only what is near them is worked off
    std::int32_t run(const Cuts& cuts) {
        if (!cuts.empty()) begin_near(cuts);
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (last_change(Vertex(i)) > tried_before_) push(Vertex(i));
        }
        most_work_ = kLeastWork + kWorkPerQuad * static_cast<std::size_t>(mesh_.face_count());
        most_tries_ = kLeastTries + kTriesPerNode * queue_.size();
        work_off();
        for (int round = 0; round < kRounds && grow_regions(); ++round) done_ = (round + 1.0) / (kRounds + 1.0);
        repair();
        return operations_;
    }

  private:
    /// As if the first operation had changed all that is near the cuts, and all had been tried before.
    void begin_near(const Cuts& cuts) {
        operations_ = last_round_ = 1;
        tried_before_ = 0;
        changed_.assign(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for_each(mesh_.vertex_slots(), context_, [&](std::int32_t i) {
            const Vertex v(i);
            if (is_in_use(v) && cuts.is_near(mesh_.position(v), kNearCut * mesh_.length(mesh_.halfedge(v))))
                changed_[static_cast<std::size_t>(i)] = operations_;
        });
    }

    bool is_in_use(Vertex v) const { return !mesh_.is_deleted(v) && mesh_.halfedge(v).is_valid(); }
    bool is_irregular(Vertex v) const { return is_in_use(v) && trial_.sectors().cost(mesh_, v) > 0; }
    bool may_try() const { return trial_.tries() < most_tries_ && trial_.work() < most_work_; }

    void push(Vertex v) {
        const auto i = static_cast<std::size_t>(v.index());
        if (queued_.size() <= i) queued_.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        if (queued_[i] || !is_irregular(v)) return;
        queued_[i] = 1;
        queue_.push(v);
    }

    /// Tells how far the clean-up is, every now and then. @throws Error{cancelled}
    void breathe() {
        if (++steps_ % 128 == 0) context_.report(done_);
    }

    /// Local patterns, until none is left.
    void work_off() {
        for (; !queue_.empty(); queue_.pop()) {
            breathe();
            const Vertex v = queue_.front();
            queued_[static_cast<std::size_t>(v.index())] = 0;
            if (!may_try() || !is_irregular(v)) continue;
            find_proposals(v, 1);
            apply_best({});
        }
    }

    /// @returns true if a region was replaced
    bool grow_regions() {
        bool replaced = false;
        Region region;
        const std::int32_t start = operations_;
        for (std::int32_t i = 0; i < mesh_.vertex_slots() && may_try(); ++i) {
            const Vertex v(i);
            breathe();
            if (last_change(v) < last_round_ || !is_irregular(v)) continue;
            if (!growth_.improve(v, {}, region)) continue;
            note_change(region);
            work_off();
            replaced = true;
        }
        last_round_ = start;
        return replaced;
    }

    /// Poor quads, with what does not make the mesh more irregular; unusable ones with what does too. Each has tries of its own,
    /// so that what is hopeless in one place takes nothing from the others.
    void repair() {
        std::size_t poor = 0;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            const Face f(i);
            poor += is_repairable(f) && is_in_reach(f) && scaled_jacobian(mesh_, f) <= kPoor ? 1 : 0;
        }
        most_tries_ = std::max(most_tries_, trial_.tries() + kTriesPerPoor * std::min(poor, kMostPoor));
        most_work_ = std::max(most_work_, trial_.work() + kWorkPerPoor * std::min(poor, kMostPoor));
        for (int round = 0; round < kRepairRounds; ++round) {
            const std::int32_t before = operations_;
            // What is flat first: slim quads between lines that meet at a small angle may use up the tries in vain.
            for (const double worst : {Trial::kUpright, kPoor}) {
                for (std::int32_t i = 0; i < mesh_.face_slots() && may_try(); ++i) repair(Face(i), worst);
            }
            for (std::int32_t i = 0; i < mesh_.face_slots() && may_try(); ++i) repair_at_a_price(Face(i));
            for (std::int32_t i = 0; i < mesh_.face_slots() && may_try(); ++i) bring_nearer(Face(i));
            work_off();
            if (operations_ == before) return;
        }
    }

    bool is_repairable(Face f) const { return !mesh_.is_deleted(f) && mesh_.is_quad(f) && mesh_.info(f).row == 0; }

    /// False for what was tried before and lies far from all that has changed since.
    bool is_in_reach(Face f) const {
        if (tried_before_ < 0) return true;
        for (const HalfEdge h : mesh_.halfedges(f)) {
            if (last_change(mesh_.from(h)) > tried_before_) return true;
        }
        return false;
    }

    /// True for faces of no row round which something changed since they were last given to this function with the same list.
    bool is_due(Face f, std::vector<std::int32_t>& tried) const {
        if (!is_repairable(f)) return false;
        const auto i = static_cast<std::size_t>(f.index());
        if (tried.size() <= i) tried.resize(static_cast<std::size_t>(mesh_.face_slots()), tried_before_);
        const std::int32_t last = std::exchange(tried[i], operations_);
        bool is_due = last < 0;
        for (const HalfEdge h : mesh_.halfedges(f)) is_due = is_due || last_change(mesh_.from(h)) > last;
        return is_due;
    }

    /// @param worst scaled Jacobian above which the quad is left as it is
    void repair(Face f, double worst) {
        breathe();
        if (!is_repairable(f) || !is_in_reach(f)) return;
        const double quality = scaled_jacobian(mesh_, f);
        if (quality > worst || !is_due(f, repaired_)) return;
        if (quality > kUnusable) {
            change_round(f, kRepair);
            return;
        }
        // Once for good, before anything will do.
        Trial::Demands thorough = kRepairAtAnyPrice;
        thorough.deficit = kThorough * (kUnusable - std::max(0.0, quality));
        if (change_at_any_scale(f, thorough)) return;
        thorough.may_leave_surface = true;
        if (quality <= Trial::kUpright && change_at_any_scale(f, thorough)) return;
        const bool changed = change_round(f, kRepairAtAnyPrice);
        // What was mended may have been a neighbour.
        if (changed && (mesh_.is_deleted(f) || !mesh_.is_quad(f) || scaled_jacobian(mesh_, f) > Trial::kUpright)) return;
        if (inset(f, kRepairAtAnyPrice) || grow_round(f, kRepairAtAnyPrice)) return;
        if (!mesh_.is_deleted(f) && mesh_.is_quad(f) && scaled_jacobian(mesh_, f) <= Trial::kUpright)
            change_at_any_scale(f, kFold);
    }

    /// Almost flat quads that could not be repaired for nothing.
    void repair_at_a_price(Face f) {
        breathe();
        if (!is_repairable(f) || !is_in_reach(f)) return;
        const double quality = scaled_jacobian(mesh_, f);
        if (quality <= kUnusable || quality > kSlim || !is_due(f, repaired_at_a_price_)) return;
        change_at_any_scale(f, kRepairAtAPrice);
    }

    /// Local patterns, an inset, then regions, until one of them meets the demands.
    bool change_at_any_scale(Face f, const Trial::Demands& demands) {
        return change_round(f, demands) || inset(f, demands) || grow_round(f, demands);
    }

    /// A quad that spans a fold of the surface is worth irregular nodes, if the new ones lie nearer.
    void bring_nearer(Face f) {
        breathe();
        if (!is_due(f, brought_nearer_) || !is_far(f)) return;
        change_at_any_scale(f, kBringNearer);
    }

    bool is_far(Face f) const {
        const Eigen::Vector3d area = doubled_area_vector_of_quad(mesh_, f);
        bool bent = false;
        for (const HalfEdge h : mesh_.halfedges(f)) {
            const Face beside = mesh_.face(M::twin(h));
            if (is_fixed(mesh_, M::edge(h)) || !mesh_.is_quad(beside)) continue;
            const Eigen::Vector3d other = doubled_area_vector_of_quad(mesh_, beside);
            bent = bent || area.dot(other) < kBent * area.norm() * other.norm();
        }
        return bent && reference_.closest(face_middle(mesh_, f), mesh_.info(f).patch).distance > kFar * reference_.diagonal();
    }

    std::array<Vertex, 4> nodes_of(Face f) const {
        std::array<Vertex, 4> nodes;
        std::size_t k = 0;
        for (const HalfEdge h : mesh_.halfedges(f)) nodes[k++] = mesh_.from(h);
        return nodes;
    }

    /// The local patterns at a quad's nodes, until one is made.
    bool change_round(Face f, const Trial::Demands& demands) {
        const std::array<Vertex, 4> nodes = nodes_of(f);
        return std::any_of(nodes.begin(), nodes.end(), [&](Vertex v) {
            find_proposals(v, demands.gain);
            return apply_best(demands);
        });
    }

    bool inset(Face f, const Trial::Demands& demands) {
        proposals_.clear();
        propose_inset(mesh_, f, proposals_);
        sort_out(demands.gain);
        return apply_best(demands);
    }

    /// Larger and larger regions round a quad's irregular nodes, until one is meshed anew.
    bool grow_round(Face f, const Trial::Demands& demands) {
        Region region;
        for (const Vertex v : nodes_of(f)) {
            if (!is_irregular(v) || !may_try() || !growth_.improve(v, {.demands = demands}, region)) continue;
            note_change(region);
            return true;
        }
        return false;
    }

    void find_proposals(Vertex v, int least_gain) {
        proposals_.clear();
        propose_doublet(mesh_, v, proposals_);
        propose_face_collapse(mesh_, v, proposals_);
        for (const HalfEdge h : mesh_.outgoing(v)) {
            if (!mesh_.is_boundary(h)) propose_collapse_of(mesh_, mesh_.next(mesh_.next(h)), proposals_);
        }
        propose_edge_rotation(mesh_, v, proposals_);
        propose_hexagon(mesh_, v, proposals_);
        propose_vertex_split(mesh_, v, proposals_);
        sort_out(least_gain);
    }

    /// What is possible and gains enough, best first.
    void sort_out(int least_gain) {
        order_.clear();
        for (std::size_t i = 0; i < proposals_.size(); ++i) {
            Proposal& p = proposals_[i];
            Region region{p.faces, {}, {}};
            if (!trial_.editor().find_outline(region)) continue;
            p.gain = trial_.gain(region, p.replacement);
            if (p.gain >= least_gain && trial_.editor().is_possible(region, p.replacement)) order_.push_back(i);
        }
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return proposals_[a].gain > proposals_[b].gain; });
    }

    bool apply_best(const Trial::Demands& demands) {
        for (const std::size_t i : order_) {
            Region region{proposals_[i].faces, {}, {}};
            if (!trial_.attempt(region, proposals_[i].replacement, demands)) continue;
            note_change(region);
            return true;
        }
        return false;
    }

    std::int32_t last_change(Vertex v) const {
        const auto i = static_cast<std::size_t>(v.index());
        return i < changed_.size() ? changed_[i] : 0;
    }

    void note_change(const Region& region) {
        ++operations_;
        changed_.resize(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        nodes_.clear(mesh_.vertex_slots());
        near_.clear(mesh_.vertex_slots());
        const auto note = [&](Vertex v) {
            if (!near_.mark(v)) return;
            changed_[static_cast<std::size_t>(v.index())] = operations_;
            push(v);
        };
        for (const Face f : region.faces) {
            for (const HalfEdge h : mesh_.halfedges(f)) {
                const Vertex v = mesh_.from(h);
                if (!nodes_.mark(v)) continue;
                note(v);
                for (const HalfEdge k : mesh_.outgoing(v)) note(mesh_.to(k));
            }
        }
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    Context& context_;
    Trial trial_;
    PatchPlanner planner_;
    RegionGrowth growth_;
    std::queue<Vertex> queue_;
    std::vector<char> queued_;
    Marks nodes_;
    Marks near_;
    std::vector<std::int32_t> changed_;   ///< per node: number of the last operation near it
    std::vector<std::int32_t> repaired_;  ///< per face: number of the last operation when its repair was last tried, −1 = never
    std::vector<std::int32_t> repaired_at_a_price_;  ///< the same for repair_at_a_price()
    std::vector<std::int32_t> brought_nearer_;       ///< the same for bring_nearer()
    std::int32_t last_round_ = 0;                    ///< number of the operation before the last round
    std::size_t most_tries_ = 0;
    std::size_t most_work_ = 0;
    std::vector<Proposal> proposals_;
    std::vector<std::size_t> order_;  ///< of those that gain enough, best first
    std::int32_t operations_ = 0;
    std::int32_t tried_before_ = -1;  ///< number of the last operation when all was tried, −1 = never
    std::int32_t steps_ = 0;
    double done_ = 0.0;  ///< share of the clean-up
};

}  // namespace

CleanupResult clean_up_near(const Cuts& cuts, SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context) {
    CleanupResult result;
    result.irregular_before = irregular_nodes(mesh);
    result.operations = Cleaner(mesh, reference, context).run(cuts);
    result.irregular_after = irregular_nodes(mesh);
    return result;
}

CleanupResult clean_up(SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context) {
    return clean_up_near({}, mesh, reference, context);
}

}  // namespace anisoquad
