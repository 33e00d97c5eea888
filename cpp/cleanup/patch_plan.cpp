#include "cleanup/patch_plan.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace anisoquad {
namespace {

/// What an arm takes from the score; arms of no length are those of nodes on a cut.
double crowding(int arm) { return arm > 0 ? 1.0 / arm : 2.0; }

PatchPlan grid_plan(const Sides& s) {
    PatchPlan plan;
    if (s[0] == s[2] && s[1] == s[3]) plan.irregular = 0;
    return plan;
}

PatchPlan star_plan(const Sides& s) {
    PatchPlan plan;
    PatchPlanner::Arms arms{};
    if (!PatchPlanner::find_arms(s, arms)) return plan;
    plan.irregular = 1;
    for (int k = 0; k < s.size(); ++k) plan.score -= crowding(arms[static_cast<std::size_t>(k)]);
    return plan;
}

/// The whole number x in [low, high] with the least total crowding of the arms x, x + up and length − x.
int least_crowded(int low, int high, int up, int length) {
    int best = low;
    double least = std::numeric_limits<double>::max();
    for (int x = low; x <= high; ++x) {
        const double c = crowding(x) + crowding(x + up) + crowding(length - x);
        if (c >= least) continue;
        least = c;
        best = x;
    }
    return best;
}

/// A grid with unequal opposite sides holds one pair of nodes with three and five edges. The cut round corner i + 1 parts them: a
/// triangle with arms α, β, γ (to the first, second side and the cut) and a pentagon with arms e1…e5. With
/// L_i − L_{i+2} = w − u and L_{i+1} − L_{i+3} = w + u all follow from α, β and e5.
PatchPlan pair_plan(const Sides& s) {
    PatchPlan best;
    for (int i = 0; i < 4; ++i) {
        const int first = s[i] - s[i + 2];
        const int second = s[i + 1] - s[i + 3];
        const int w = (first + second) / 2;
        const int u = (second - first) / 2;
        if ((first + second) % 2 != 0 || w < 1) continue;
        const int e5 = (w + 1) / 2;
        const int gamma = w - e5;
        // β, e1 = β + u and e3 = L2 − e1; α, e4 = α − u and e2 = L3 − e4: all at least 1
        const int beta_low = std::max(1, 1 - u);
        const int beta_high = s[i + 2] - u - 1;
        const int alpha_low = std::max(1, 1 + u);
        const int alpha_high = s[i + 3] + u - 1;
        if (beta_low > beta_high || alpha_low > alpha_high) continue;
        const int beta = least_crowded(beta_low, beta_high, u, s[i + 2] - u);
        const int alpha = least_crowded(alpha_low, alpha_high, -u, s[i + 3] + u);
        const int e1 = beta + u;
        const int e4 = alpha - u;
        const int e3 = s[i + 2] - e1;
        const int e2 = s[i + 3] - e4;
        PatchPlan plan;
        plan.irregular = 2;
        plan.cut = true;
        plan.i = i;
        plan.j = i + 1;
        plan.p = e3 + e5;
        plan.q = alpha + gamma;
        plan.r = alpha + beta;
        plan.left_budget = 1;
        plan.right_budget = 1;
        for (const int arm : {alpha, beta, gamma, e1, e2, e3, e4, e5}) plan.score -= crowding(arm);
        if (plan.is_better_than(best)) best = plan;
    }
    return best;
}

}  // namespace

int Sides::sum() const { return std::accumulate(edges_.begin(), edges_.begin() + size_, 0); }
int Sides::longest() const { return *std::max_element(edges_.begin(), edges_.begin() + size_); }

bool PatchPlanner::find_arms(const Sides& sides, Arms& arms) {
    const int n = sides.size();
    const int shortest = n == 3 ? 0 : 1;
    // Going round in steps of two, arm_{k+2} = l_{k+1} − arm_k; after n steps (n odd) all arms were met once.
    int first = 0;
    for (int step = 0, sign = 1; step < n; ++step, sign = -sign) first += sign * sides[2 * (n - 1 - step) + 1];
    if (first % 2 != 0) return false;
    int arm = first / 2;
    for (int step = 0; step < n; ++step) {
        if (arm < shortest) return false;
        arms[static_cast<std::size_t>((2 * step) % n)] = arm;
        arm = sides[2 * step + 1] - arm;
    }
    return true;
}

void PatchPlanner::pieces(const Sides& sides, const PatchPlan& cut, Sides& left, Sides& right) {
    left = {};
    left.push_back(sides[cut.i] - cut.p);
    for (int k = cut.i + 1; k < cut.j; ++k) left.push_back(sides[k]);
    left.push_back(cut.q);
    left.push_back(cut.r);
    right = {};
    right.push_back(sides[cut.j] - cut.q);
    for (int k = cut.j + 1; k < cut.i + sides.size(); ++k) right.push_back(sides[k]);
    right.push_back(cut.p);
    right.push_back(cut.r);
}

PatchPlan PatchPlanner::plan(const Sides& sides, int budget) {
    const int n = sides.size();
    if (budget < std::abs(n - 4) || sides.sum() % 2 != 0) return {};
    if (n == 4) {
        const PatchPlan grid = grid_plan(sides);
        return grid.is_possible() || budget < 2 ? grid : pair_plan(sides);
    }
    if (n % 2 == 1) {
        const PatchPlan star = star_plan(sides);
        if (star.is_possible() || budget < 3) return star;
    }
    const auto key = std::pair(sides, std::min(budget, 3));
    const auto at = known_.find(key);
    if (at != known_.end()) return at->second;
    return known_.emplace(key, find(sides, budget)).first->second;
}

void PatchPlanner::try_cuts(const Sides& sides, int distance, int left_budget, int right_budget, PatchPlan& best) {
    const int longest = sides.sum() / 2;
    Sides left;
    Sides right;
    PatchPlan trial;
    trial.cut = true;
    trial.left_budget = left_budget;
    trial.right_budget = right_budget;
    for (trial.i = 0; trial.i < sides.size(); ++trial.i) {
        trial.j = trial.i + distance;
        for (trial.p = 1; trial.p < sides[trial.i]; ++trial.p) {
            for (trial.q = 1; trial.q < sides[trial.j]; ++trial.q) {
                for (trial.r = 1; trial.r < longest; ++trial.r) {
                    pieces(sides, trial, left, right);
                    const PatchPlan a = plan(left, left_budget);
                    if (!a.is_possible()) continue;
                    const PatchPlan b = plan(right, right_budget);
                    if (!b.is_possible()) continue;
                    trial.irregular = a.irregular + b.irregular;
                    trial.score = a.score + b.score;
                    if (trial.is_better_than(best)) best = trial;
                }
            }
        }
    }
}

PatchPlan PatchPlanner::find(const Sides& sides, int budget) {
    PatchPlan best;
    switch (sides.size()) {
        case 2: try_cuts(sides, 1, 1, 1, best); break;
        case 6: try_cuts(sides, 3, 1, 1, best); break;
        case 3:
            if (budget >= 3) try_cuts(sides, 1, 1, 2, best);
            break;
        case 5:
            if (budget < 3) break;
            // The piece on the left is always the pentagon, which is decided faster.
            try_cuts(sides, 3, 1, 2, best);
            break;
        default: break;
    }
    return best;
}

}  // namespace anisoquad
