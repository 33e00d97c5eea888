#include "cleanup/cleanup.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "cleanup/patterns.h"
#include "cleanup/region_growth.h"
#include "cleanup/trial.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr double kBound = 0.4;  ///< scaled Jacobian that the worst element round a change must have if it was better before

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
        : mesh_(mesh), context_(context), trial_(mesh, reference), growth_(trial_, planner_) {}

    std::int32_t run() {
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) push(Vertex(i));
        work_off();
        std::vector<Vertex> seeds;
        for (int round = 0; round < 6; ++round) {
            const std::int32_t before = operations_;
            seeds.clear();
            for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
                if (is_irregular(Vertex(i))) seeds.push_back(Vertex(i));
            }
            Region region;
            for (const Vertex v : seeds) {
                if (!is_irregular(v) || !growth_.improve(v, {}, region)) continue;
                ++operations_;
                requeue(region);
                work_off();
            }
            if (operations_ == before) break;
        }
        return operations_;
    }

  private:
    bool is_irregular(Vertex v) const { return !mesh_.is_deleted(v) && mesh_.halfedge(v).is_valid() && trial_.sectors().cost(mesh_, v) > 0; }

    void work_off() {
        const std::size_t limit = 20 * queue_.size() + 100;
        for (std::size_t done = 0; !queue_.empty() && done < limit; ++done) {
            if (done % 256 == 0) context_.report(static_cast<double>(done) / static_cast<double>(done + queue_.size()));
            const Vertex v = queue_.front();
            queue_.pop();
            queued_[static_cast<std::size_t>(v.index())] = 0;
            if (!mesh_.is_deleted(v) && mesh_.halfedge(v).is_valid()) visit(v);
        }
    }

    void push(Vertex v) {
        const auto i = static_cast<std::size_t>(v.index());
        if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || trial_.sectors().cost(mesh_, v) == 0) return;
        if (queued_.size() <= i) queued_.resize(i + 1, 0);
        if (queued_[i]) return;
        queued_[i] = 1;
        queue_.push(v);
    }

    void visit(Vertex v) {
        if (trial_.sectors().cost(mesh_, v) == 0) return;
        proposals_.clear();
        propose_doublet(mesh_, v, proposals_);
        if (proposals_.empty()) {
            propose_face_collapse(mesh_, v, proposals_);
            for (const HalfEdge h : mesh_.outgoing(v)) {
                if (!mesh_.is_boundary(h)) collapse_into(h);
            }
            propose_edge_rotation(mesh_, v, proposals_);
            propose_vertex_split(mesh_, v, proposals_);
        }
        order_.clear();
        for (std::size_t i = 0; i < proposals_.size(); ++i) {
            Proposal& p = proposals_[i];
            Region region{p.faces, {}, {}};
            if (!trial_.editor().find_outline(region) || !trial_.editor().is_possible(region, p.replacement)) continue;
            p.gain = trial_.gain(region, p.replacement);
            if (p.gain > 0) order_.push_back(i);
        }
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return proposals_[a].gain > proposals_[b].gain; });
        for (const std::size_t i : order_) {
            Region region{proposals_[i].faces, {}, {}};
            if (!trial_.attempt(region, proposals_[i].replacement, 1, kBound)) continue;
            ++operations_;
            requeue(region);
            return;
        }
    }

    /// Also the collapse that moves the opposite node of a quad into this one.
    void collapse_into(HalfEdge h) {
        const Vertex v = mesh_.from(h);
        const std::size_t first = proposals_.size();
        propose_face_collapse(mesh_, mesh_.to(mesh_.next(h)), proposals_);
        const auto other = [&](const Proposal& p) { return p.faces[0] != mesh_.face(h); };
        proposals_.erase(std::remove_if(proposals_.begin() + static_cast<std::ptrdiff_t>(first), proposals_.end(), other), proposals_.end());
        static_cast<void>(v);
    }

    void requeue(const Region& region) {
        for (const Face f : region.faces) {
            for (const HalfEdge h : mesh_.halfedges(f)) {
                for (const HalfEdge k : mesh_.outgoing(mesh_.from(h))) {
                    push(mesh_.from(k));
                    push(mesh_.to(k));
                }
            }
        }
    }

    SurfaceMesh& mesh_;
    Context& context_;
    Trial trial_;
    PatchPlanner planner_;
    RegionGrowth growth_;
    std::queue<Vertex> queue_;
    std::vector<char> queued_;
    std::vector<Proposal> proposals_;
    std::vector<std::size_t> order_;
    std::int32_t operations_ = 0;
};

}  // namespace

CleanupResult clean_up(SurfaceMesh& mesh, const ReferenceSurface& reference, Context& context) {
    CleanupResult result;
    result.irregular_before = irregular_nodes(mesh);
    result.operations = Cleaner(mesh, reference, context).run();
    result.irregular_after = irregular_nodes(mesh);
    return result;
}

}  // namespace anisoquad
