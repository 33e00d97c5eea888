#include "qmorph/qmorph.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "mesh/euler_operators.h"
#include "qmorph/closure.h"
#include "qmorph/edge_recovery.h"
#include "qmorph/front.h"
#include "qmorph/quad_formation.h"
#include "qmorph/rung.h"
#include "qmorph/seam.h"
#include "qmorph/seed.h"
#include "qmorph/sharp_corner.h"
#include "qmorph/side_edge.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr int kMostEdgesAtTransition = 16;  // of the nodes at a transition seam or split
constexpr int kTries = 4;                   // of one front edge before it is left to finish_remaining()
constexpr int kLate = 64;                   // level
constexpr int kMostEdgesLate = 64;          // of the nodes of a front edge of a later level
constexpr double kLeastLengthLate = 0.02;   // of a front edge of a later level, over the wanted size

/// A front edge that waits: those at whose ends the front turns sharply first, then those of a lower level, then shorter ones,
/// then those of a lower index, which are near each other. A length counts by its class alone: within one, neighbours follow
/// each other, and find in the cache what they need.
class Waiting {
  public:
    /// @param sharp_ends 0 … 2; @param tries failed ones
    Waiting(int sharp_ends, int tries, std::int32_t level, double length, HalfEdge h, std::int32_t stamp)
        : key_(static_cast<std::uint64_t>(2 - sharp_ends + 3 * tries) << kTriesShift |
               static_cast<std::uint64_t>(std::min(level, kMostLevel)) << kLevelShift |
               static_cast<std::uint64_t>(length_class(length)) << kLengthShift | static_cast<std::uint32_t>(h.index())),
          stamp_(stamp) {}

    HalfEdge halfedge() const { return HalfEdge(static_cast<std::int32_t>(key_ & 0xffffffffu)); }
    std::int32_t stamp() const { return stamp_; }
    /// std::priority_queue takes the greatest first.
    bool operator<(const Waiting& other) const { return std::tie(other.key_, other.stamp_) < std::tie(key_, stamp_); }

  private:
    static constexpr int kLengthShift = 32;
    static constexpr int kLevelShift = 46;
    static constexpr int kTriesShift = 60;
    static constexpr std::int32_t kMostLevel = (1 << 14) - 1;
    static constexpr int kDropped = 18;  ///< bits of a float that do not count
    /// Thirty-two classes to each power of two: the leading bits of a positive float grow with it.
    static std::uint32_t length_class(double length) {
        return std::bit_cast<std::uint32_t>(static_cast<float>(length)) >> kDropped;
    }

    std::uint64_t key_;
    std::int32_t stamp_;
};

class QMorph {
  public:
    QMorph(SurfaceMesh& mesh, const ReferenceSurface* reference, Context& context, const Cuts& cuts)
        : mesh_(mesh), reference_(reference), context_(context), cuts_(cuts) {}

    QMorphResult run() {
        start_closed_components(mesh_);
        context_.breathe();
        result_.quads += fill_sharp_corners(mesh_, cuts_);
        context_.breathe();
        triangles_ = 0;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            triangles_ += !mesh_.is_deleted(Face(i)) && mesh_.is_triangle(Face(i));
        }
        for (std::int32_t i = 0; i < mesh_.halfedge_slots(); ++i) {
            context_.breathe_at(i);
            if (!mesh_.is_deleted(HalfEdge(i)) && is_front(mesh_, HalfEdge(i))) push(HalfEdge(i));
        }
        std::int64_t steps = 0;
        const std::int64_t most = 40 * static_cast<std::int64_t>(triangles_) + 1000;  // a limit on work per triangle
        while (!queue_.empty() && steps < most) {
            const Waiting top = queue_.top();
            queue_.pop();
            if (!is_current(top)) continue;
            if (++steps % 1024 == 0) context_.report(std::min(0.99, 2.0 * result_.quads / std::max(1, triangles_)));
            advance(top.halfedge());
        }
        if (!cuts_.empty()) return result_;
        const FinishResult finish = finish_remaining(mesh_);
        result_.paired = finish.pairs;
        result_.walks = finish.walks;
        result_.left = finish.left;
        return result_;
    }

  private:
    struct EdgeState {
        std::int32_t level = 0;
        std::int32_t stamp = 0;
        std::int32_t tries = 0;
    };

    EdgeState& state(HalfEdge h) {
        if (states_.size() < static_cast<std::size_t>(mesh_.halfedge_slots()))
            states_.resize(static_cast<std::size_t>(mesh_.halfedge_slots()));
        return states_[static_cast<std::size_t>(h.index())];
    }

    void push(HalfEdge h) {
        EdgeState& s = state(h);
        if (s.tries >= kTries || is_near_cut(mesh_, h, cuts_)) return;
        ++s.stamp;
        const int sharp_ends =
            is_front_angle_below(mesh_, h, kSideAngle) + is_front_angle_below(mesh_, previous_front(mesh_, h), kSideAngle);
        queue_.push({sharp_ends, s.tries, s.level, mesh_.length(h), h, s.stamp});
    }

    bool is_current(const Waiting& w) {
        const HalfEdge h = w.halfedge();
        return !mesh_.is_deleted(h) && state(h).stamp == w.stamp() && is_front(mesh_, h);
    }

    void advance(HalfEdge h) {
        const int length = loop_length(mesh_, h, 6);
        if ((length == 4 || length == 6) && close_small_loop(mesh_, h, length, spirals(h))) {
            ++result_.closed_loops;
            return;
        }
        if (try_seam(previous_front(mesh_, h)) || try_seam(h)) {
            if (!mesh_.is_deleted(h) && is_front(mesh_, h)) push(h);
            return;
        }
        // A transition seam that could not be closed has halved an edge: h may be gone.
        if (mesh_.is_deleted(h) || !is_front(mesh_, h)) return;
        if (is_wide_rung(mesh_, h)) {
            const std::int32_t level = state(h).level;
            const Face middle = split_rung(mesh_, h, reference_);
            ++result_.rungs;
            result_.quads += 3;
            settle(middle, level);
            return;
        }
        if (make_quad(h)) {
            ++result_.quads;
            return;
        }
        if (mesh_.is_deleted(h) || !is_front(mesh_, h)) return;
        EdgeState& s = state(h);
        if (++s.tries >= kTries) ++result_.failed_edges;
        push(h);
    }

    /// Each quad follows on the last one: the edges of a small loop differ in level.
    bool spirals(HalfEdge h) {
        const std::int32_t level = state(h).level;
        for (HalfEdge k = next_front(mesh_, h); k != h; k = next_front(mesh_, k)) {
            if (state(k).level != level) return true;
        }
        return false;
    }

    bool try_seam(HalfEdge h) {
        const SeamKind kind = classify_seam(mesh_, h);
        if (kind == SeamKind::none) return false;
        if (kind != SeamKind::seam && !may_make_transition(h)) return false;
        const std::int32_t level = state(h).level;
        const Vertex node = mesh_.to(h);
        if (kind == SeamKind::seam) {
            const Vertex merged = seam(mesh_, h);
            if (!merged.is_valid()) return false;
            ++result_.seams;
            refresh({&merged, 1}, level);
            return true;
        }
        if (kind == SeamKind::transition_seam) {
            const Face f = transition_seam(mesh_, h);
            if (f.is_valid()) {
                ++result_.transitions;
                settle(f, level + 1);
                return true;
            }
            refresh({&node, 1}, level);
            return false;
        }
        const Vertex m = transition_split(mesh_, h);
        if (!m.is_valid()) return false;
        ++result_.transitions;
        refresh(std::array{m, node}, level);
        return true;
    }

    /// Splits and seams can undo each other: a bound for their number keeps the work per triangle limited. Each leaves an edge
    /// more at a node beside it, which tells where they follow each other at one place.
    bool may_make_transition(HalfEdge h) const {
        if (10 * result_.transitions > triangles_ + 100) return false;
        const std::array<Vertex, 3> nodes{mesh_.from(h), mesh_.to(h), mesh_.to(next_front(mesh_, h))};
        return std::all_of(nodes.begin(), nodes.end(), [&](Vertex v) { return mesh_.valence(v) <= kMostEdgesAtTransition; });
    }

    /// New front edges at the nodes get the level; all front edges there are classified anew, each once.
    void refresh(std::span<const Vertex> nodes, std::int32_t level) {
        to_push_.clear();
        for (const Vertex v : nodes) {
            if (mesh_.is_deleted(v)) continue;
            for (const HalfEdge out : mesh_.outgoing(v)) {
                for (const HalfEdge k : {out, M::twin(out)}) {
                    if (is_front(mesh_, k) && std::find(to_push_.begin(), to_push_.end(), k) == to_push_.end())
                        to_push_.push_back(k);
                }
            }
        }
        for (const HalfEdge k : to_push_) {
            EdgeState& s = state(k);
            if (s.stamp == 0) s.level = level;
            push(k);
        }
    }

    /// After a new quad: its surroundings are smoothed, and the front there is classified anew.
    void settle(Face quad, std::int32_t level) {
        smooth_around(mesh_, quad, reference_, hints_);
        std::array<Vertex, 4> nodes;
        std::size_t n = 0;
        for (const HalfEdge k : mesh_.halfedges(quad)) nodes[n++] = mesh_.from(k);
        refresh(nodes, level);
    }

    /// Between slivers that are folded over, quad can follow quad without end: round the same nodes, or smaller and smaller.
    bool is_endless(HalfEdge h) {
        if (state(h).level <= kLate) return false;
        const Vertex a = mesh_.from(h);
        const Vertex b = mesh_.to(h);
        if (std::max(mesh_.valence(a), mesh_.valence(b)) > kMostEdgesLate) return true;
        return mesh_.length(h) < kLeastLengthLate * std::max(mesh_.info(a).size, mesh_.info(b).size);
    }

    bool make_quad(HalfEdge h) {
        const Vertex a = mesh_.from(h);
        const Vertex b = mesh_.to(h);
        if (is_endless(h)) return false;
        const HalfEdge right = choose_side_edge(mesh_, h, End::right, a);
        if (!right.is_valid() || !is_front(mesh_, h)) return false;
        Vertex c = mesh_.to(right);
        HalfEdge left = choose_side_edge(mesh_, h, End::left, c);
        if (!left.is_valid()) return false;
        Vertex d = mesh_.to(left);
        if (c == d || c == a || d == b) return false;
        const HalfEdge top = recover_edge(mesh_, c, d);
        if (!top.is_valid() || !is_front(mesh_, h)) return false;
        const std::int32_t level = state(h).level + 1;
        const Face f = form_quad(mesh_, h, c, d);
        if (!f.is_valid()) return false;
        // Slots of edges are reused: what is new on the front starts with a fresh state.
        for (const HalfEdge k : mesh_.halfedges(f)) {
            if (is_front(mesh_, M::twin(k))) {
                EdgeState& s = state(M::twin(k));
                s.level = level;
                s.tries = 0;
            }
        }
        settle(f, level);
        return true;
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface* reference_;
    FacetHints hints_;
    Context& context_;
    const Cuts& cuts_;
    QMorphResult result_;
    std::priority_queue<Waiting> queue_;
    std::vector<EdgeState> states_;
    std::vector<HalfEdge> to_push_;
    std::int32_t triangles_ = 0;
};

}  // namespace

QMorphResult fill_with_quads(SurfaceMesh& mesh, const ReferenceSurface* reference, Context& context, const Cuts& cuts) {
    return QMorph(mesh, reference, context, cuts).run();
}

}  // namespace anisoquad
