#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>

namespace anisoquad {

/// Number of edges of each side of a patch, counter-clockwise.
class Sides {
  public:
    static constexpr int kMost = 6;

    void push_back(int edges) { edges_[static_cast<std::size_t>(size_++)] = static_cast<std::int16_t>(edges); }
    int size() const { return size_; }
    /// Any index: sides are counted round and round.
    int operator[](int i) const { return edges_[static_cast<std::size_t>(i % size_)]; }
    int sum() const;
    int longest() const;
    auto operator<=>(const Sides&) const = default;

  private:
    std::array<std::int16_t, kMost> edges_{};
    std::int8_t size_ = 0;
};

/// How a patch with N sides is filled with quads and few irregular nodes (after @cite takayama2014patterns,
/// @cite verma2017regularization): as a grid (N = 4), with one irregular node (N = 3 or 5), or cut in two by a line of nodes
/// from one side to another.
struct PatchPlan {
    int irregular = -1;  ///< number of irregular nodes inside, −1 = not possible
    bool cut = false;
    // The cut leaves side i after p edges and arrives on side j (i < j < i + N, modulo N) after q edges; it has r edges.
    int i = 0;
    int j = 0;
    int p = 0;
    int q = 0;
    int r = 0;
    int left_budget = 0;  ///< budgets with which the two pieces are planned
    int right_budget = 0;
    double score = 0.0;  ///< −Σ 1/arm over the arms of all irregular nodes: small where they crowd

    bool is_possible() const { return irregular >= 0; }
    bool is_better_than(const PatchPlan& other) const {
        if (!is_possible() || !other.is_possible()) return is_possible();
        return irregular != other.irregular ? irregular < other.irregular : score > other.score;
    }
};

/// Plans are remembered: many patches of one mesh are alike.
class PatchPlanner {
  public:
    /// The best plan with at most `budget` irregular nodes, up to 3 of them. @pre 2 to 6 sides of at least one edge
    PatchPlan plan(const Sides& sides, int budget);

    using Arms = std::array<int, Sides::kMost>;
    /// Edges from the one irregular node to each side: l_i = arm_{i−1} + arm_{i+1}, N odd. In a triangle one arm may be 0: the
    /// irregular node then lies on that side, and the patch is a grid that has its fourth corner there.
    /// @returns false if the arms are not whole or too short
    static bool find_arms(const Sides& sides, Arms& arms);
    /// The pieces of a cut patch, each beginning with the rest of the side that the cut leaves or arrives on and ending with
    /// the cut.
    static void pieces(const Sides& sides, const PatchPlan& cut, Sides& left, Sides& right);

  private:
    PatchPlan find(const Sides& sides, int budget);
    void try_cuts(const Sides& sides, int distance, int left_budget, int right_budget, PatchPlan& best);

    std::map<std::pair<Sides, int>, PatchPlan> known_;
};

}  // namespace anisoquad
