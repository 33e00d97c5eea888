#include "surface/facet_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/z_curve.h"
#include "parallel.h"
#include "surface/closest_on_triangle.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLeafSize = 4;
constexpr int kStackSize = 96;            ///< two cuts halve, also between patches: the depth is below 70
constexpr int kWalkLimit = 64;            ///< facets
constexpr double kNearOfHeight = 0.05;    ///< distance at which a walk's end needs no search: over the least height of the facet
constexpr double kNearOfDiagonal = 2e-4;  ///< and over the diagonal
constexpr double kRounding = 1.0 + 1e-12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool any(std::int32_t /*facet*/) { return true; }

FacetTree::Hit none() { return {std::numeric_limits<double>::infinity(), -1, Point::Zero(), Vector3d::Zero()}; }

double distance2_to_box(const Point& p, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
    return (low.cast<double>() - p).cwiseMax(p - high.cast<double>()).cwiseMax(0.0).squaredNorm();
}

/// The next float below (towards −∞) or above, so that a box in floats holds what is in the box in doubles.
Eigen::Vector3f rounded(const Vector3d& p, float towards) {
    return p.cast<float>().unaryExpr([towards](float x) { return std::nextafter(x, towards); });
}

}  // namespace

FacetTree::FacetTree(std::vector<Point> points, std::span<const std::array<std::int32_t, 3>> facets,
                     std::span<const std::int32_t> patch, const Context& context)
    : points_(std::move(points)), facets_(facets.size()) {
    Eigen::AlignedBox3d box;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        facets_[f].corner = facets[f];
        if (!patch.empty()) facets_[f].patch = patch[f];
        for (const std::int32_t v : facets[f]) box.extend(points_[at(v)]);
    }
    diagonal_ = box.isEmpty() ? 0.0 : box.diagonal().norm();
    context.breathe();
    find_neighbours();
    context.breathe();
    measure_facets();
    build_tree(context);
}

void FacetTree::find_neighbours() {
    // Edges in the order of their lower vertex, then of their facets: those of one vertex are few.
    struct Side {
        std::int32_t high, corner;  ///< corner: 3 · facet + place in it
    };
    std::vector<std::int32_t> first(points_.size() + 1, 0);
    const auto ends = [this](std::int32_t f, std::int32_t k) { return std::minmax(facet(f)[at(k)], facet(f)[at((k + 1) % 3)]); };
    for (std::int32_t f = 0; f < count(); ++f) {
        for (std::int32_t k = 0; k < 3; ++k) ++first[at(ends(f, k).first) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Side> sides(3 * facets_.size());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::int32_t f = 0; f < count(); ++f) {
        for (std::int32_t k = 0; k < 3; ++k) {
            const auto [low, high] = ends(f, k);
            sides[at(next[at(low)]++)] = {high, 3 * f + k};
        }
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
        const auto begin = sides.begin() + first[v];
        const auto end = sides.begin() + first[v + 1];
        std::sort(begin, end,
                  [](const Side& a, const Side& b) { return std::tie(a.high, a.corner) < std::tie(b.high, b.corner); });
        for (auto a = begin; a != end; ++a) {
            const auto b = a + 1;
            if (b == end || a->high != b->high) continue;
            facets_[at(a->corner / 3)].neighbour[at(a->corner % 3)] = b->corner / 3;
            facets_[at(b->corner / 3)].neighbour[at(b->corner % 3)] = a->corner / 3;
        }
    }
}

void FacetTree::measure_facets() {
    for_each(count(), [&](std::int32_t f) {
        const double near = std::min(kNearOfHeight * height(f), kNearOfDiagonal * diagonal_);
        facets_[at(f)].near2 = static_cast<float>(near * near);
    });
}

double FacetTree::height(std::int32_t f) const {
    const auto& t = facet(f);
    const Vector3d a = point(t[1]) - point(t[0]);
    const Vector3d b = point(t[2]) - point(t[0]);
    const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return longest2 > 0.0 ? a.cross(b).norm() / std::sqrt(longest2) : 0.0;
}

/// The facets of each patch stand together, the patches along a Z-order curve of their middles, the facets of each along one too.
void FacetTree::order_facets() {
    const auto middle = [this](std::int32_t f) -> Point {
        const auto& [a, b, c] = facet(f);
        return (points_[at(a)] + points_[at(b)] + points_[at(c)]) / 3.0;
    };
    order_ = order_along_z_curve(count(), middle);
    std::int32_t patches = 0;
    for (const Facet& f : facets_) patches = std::max(patches, f.patch + 1);
    patch_root_.assign(at(patches), -1);
    if (patches < 2) return;
    std::vector<Point> middles(at(patches), Point::Zero());
    std::vector<std::int32_t> next(at(patches), 0);
    for (std::int32_t f = 0; f < count(); ++f) {
        middles[at(patch(f))] += middle(f);
        ++next[at(patch(f))];
    }
    for (std::size_t p = 0; p < middles.size(); ++p) middles[p] /= std::max(1, next[p]);
    std::int32_t first = 0;
    for (const std::int32_t p : order_along_z_curve(middles)) first += std::exchange(next[at(p)], first);
    std::vector<std::int32_t> order(order_.size());
    for (const std::int32_t f : order_) order[at(next[at(patch(f))]++)] = f;
    order_ = std::move(order);
}

/// Where to cut a range of order_: in the middle, or between two patches where that is nearest to it.
std::int32_t FacetTree::cut(std::int32_t first, std::int32_t last) const {
    const auto patch_at = [this](std::int32_t i) { return patch(order_[at(i)]); };
    const std::int32_t half = first + (last - first) / 2;
    if (patch_at(first) == patch_at(last - 1)) return half;
    const auto begin = order_.begin() + first;
    const auto of_half = [&](std::int32_t f) { return patch(f) == patch_at(half); };
    const auto low = static_cast<std::int32_t>(
        std::find_if(std::make_reverse_iterator(order_.begin() + half), std::make_reverse_iterator(begin), std::not_fn(of_half))
            .base() -
        order_.begin());
    const auto high = static_cast<std::int32_t>(std::find_if(order_.begin() + half, order_.begin() + last, std::not_fn(of_half)) -
                                                order_.begin());
    return low > first && (high == last || half - low <= high - half) ? low : high;
}

void FacetTree::build_tree(const Context& context) {
    nodes_.clear();
    if (facets_.empty()) return;
    nodes_.reserve(facets_.size());
    context.breathe();
    order_facets();
    context.breathe();

    // Parts of the order down to the leaves, each node before its children.
    struct Task {
        std::int32_t first, last, parent;  ///< parent: the node whose right child this is, -1 = a left child
    };
    std::vector<Task> tasks{{0, count(), -1}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto index = static_cast<std::int32_t>(nodes_.size());
        if (task.parent >= 0) nodes_[at(task.parent)].first = index;
        Node& node = nodes_.emplace_back();
        const bool is_uniform = patch(order_[at(task.first)]) == patch(order_[at(task.last - 1)]);
        if (is_uniform) {
            std::int32_t& root = patch_root_[at(patch(order_[at(task.first)]))];
            if (root < 0) root = index;
        }
        if (task.last - task.first > kLeafSize || !is_uniform) {
            const std::int32_t middle = cut(task.first, task.last);
            tasks.push_back({middle, task.last, index});
            tasks.push_back({task.first, middle, -1});
        } else {
            node.first = task.first;
            node.count = task.last - task.first;
        }
    }
    context.breathe();
    // Their boxes from the leaves up.
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        if (node->count > 0) {
            Eigen::AlignedBox3d box;
            for (std::int32_t i = node->first; i < node->first + node->count; ++i) {
                const std::int32_t f = order_[at(i)];
                for (const std::int32_t v : facet(f)) box.extend(points_[at(v)]);
            }
            node->low = rounded(box.min(), -std::numeric_limits<float>::infinity());
            node->high = rounded(box.max(), std::numeric_limits<float>::infinity());
        } else {
            const Node& left = *(node - 1);
            const Node& right = nodes_[at(node->first)];
            node->low = left.low.cwiseMin(right.low);
            node->high = left.high.cwiseMax(right.high);
        }
    }
}

void FacetTree::try_facet(const Point& p, std::int32_t facet, std::int32_t patch, Hit& best) const {
    const Facet& tried = facets_[at(facet)];
    if (patch != kAnyPatch && tried.patch != patch) return;
    const auto& [a, b, c] = tried.corner;
    const Point& pa = points_[at(a)];
    const Vector3d weights = closest_weights(p, pa, points_[at(b)], points_[at(c)]);
    const Point position = pa + weights[1] * (points_[at(b)] - pa) + weights[2] * (points_[at(c)] - pa);
    const double distance2 = (position - p).squaredNorm();
    if (distance2 < best.distance2 || (distance2 == best.distance2 && facet < best.facet))
        best = {distance2, facet, position, weights};
}

/// Over the edges beyond which p lies, from facet to facet, until p lies over one, or none beyond is closer.
/// @returns true if the point found is near for the facet's size
bool FacetTree::walk(const Point& p, std::int32_t patch, std::int32_t hint, Hit& best) const {
    try_facet(p, hint, patch, best);
    if (best.facet != hint) return false;
    std::int32_t before = -1;
    for (int step = 0; step < kWalkLimit; ++step) {
        const std::int32_t facet = best.facet;
        const Facet& here = facets_[at(facet)];
        const Vector3d weights = best.weights;
        // Across the edges that the point lies on: the one from corner k to k + 1 has no weight at k + 2.
        for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t other = here.neighbour[at(k)];
            if (weights[(k + 2) % 3] == 0.0 && other >= 0 && other != before) try_facet(p, other, patch, best);
            if (weights[k] == 1.0 && best.facet == facet) try_round(p, here.corner[at(k)], facet, patch, best);
        }
        if (best.facet == facet) return best.distance2 <= here.near2;
        before = facet;
    }
    return false;
}

/// All facets round a corner, which may be closer though the ones beside the first are not.
void FacetTree::try_round(const Point& p, std::int32_t corner, std::int32_t first, std::int32_t patch, Hit& best) const {
    for (const int way : {0, 2}) {
        std::int32_t facet = first;
        for (int step = 0; step < kWalkLimit; ++step) {
            const Facet& here = facets_[at(facet)];
            const int k = here.corner[0] == corner ? 0 : (here.corner[1] == corner ? 1 : 2);
            facet = here.neighbour[at((k + way) % 3)];
            if (facet == first) return;
            if (facet < 0) break;
            try_facet(p, facet, patch, best);
        }
    }
}

FacetTree::Hit FacetTree::closest(const Point& p, std::int32_t patch, std::int32_t hint) const {
    Hit best = none();
    if (hint >= 0 && hint < count() && walk(p, patch, hint, best)) return best;
    search(p, patch, any, best);
    return best;
}

FacetTree::Hit FacetTree::closest_facing(const Point& p, std::int32_t patch, const Vector3d& up, double reach) const {
    Hit best = none();
    best.distance2 = reach * reach;
    const auto faces_up = [&](std::int32_t f) {
        const auto& [a, b, c] = facet(f);
        return (points_[at(b)] - points_[at(a)]).cross(points_[at(c)] - points_[at(a)]).dot(up) > 0.0;
    };
    search(p, patch, faces_up, best);
    return best;
}

FacetTree::Hit FacetTree::closest_or_within(const Point& p, std::int32_t patch, std::int32_t hint, double enough2) const {
    Hit best = none();
    if (hint >= 0 && hint < count()) walk(p, patch, hint, best);
    if (best.distance2 > enough2) search(p, patch, any, best);
    return best;
}

/// The closest point of the facets that count, if it is closer than the best one so far.
template <class IsMeant>
void FacetTree::search(const Point& p, std::int32_t patch, IsMeant is_meant, Hit& best) const {
    if (nodes_.empty() || patch >= static_cast<std::int32_t>(patch_root_.size())) return;
    const std::int32_t root = patch == kAnyPatch ? 0 : patch_root_[at(patch)];
    if (root < 0) return;
    struct Entry {
        std::int32_t node;
        double distance2;
    };
    std::array<Entry, kStackSize> stack;
    int top = 0;
    stack[0] = {root, 0.0};
    while (top >= 0) {
        const Entry entry = stack[at(top--)];
        // Equally close boxes are opened too, and those that rounding alone makes farther: of equally close facets the lowest
        // index wins, whatever came first.
        if (entry.distance2 > best.distance2 * kRounding) continue;
        const Node& node = nodes_[at(entry.node)];
        if (node.count > 0) {
            for (std::int32_t i = 0; i < node.count; ++i) {
                const std::int32_t f = order_[at(node.first + i)];
                if (is_meant(f)) try_facet(p, f, patch, best);
            }
            continue;
        }
        Entry near{entry.node + 1, distance2_to_box(p, nodes_[at(entry.node + 1)].low, nodes_[at(entry.node + 1)].high)};
        Entry far{node.first, distance2_to_box(p, nodes_[at(node.first)].low, nodes_[at(node.first)].high)};
        if (far.distance2 < near.distance2) std::swap(near, far);
        if (far.distance2 <= best.distance2 * kRounding) stack[at(++top)] = far;
        if (near.distance2 <= best.distance2 * kRounding) stack[at(++top)] = near;
    }
}

}  // namespace anisoquad
