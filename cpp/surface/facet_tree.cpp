#include "surface/facet_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "surface/closest_on_triangle.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLeafSize = 4;
constexpr int kStackSize = 96;      ///< median splits halve: the depth is below 40
constexpr int kWalkLimit = 64;      ///< facets
constexpr double kNearOfHeight = 0.05;    ///< distances at which a walk's end needs no search: over the smallest height of the facet
constexpr double kNearOfDiagonal = 2e-4;  ///< and over the diagonal
constexpr double kRounding = 1.0 + 1e-12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double distance2_to_box(const Point& p, const Vector3d& low, const Vector3d& high) {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

FacetTree::FacetTree(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> facets, std::span<const std::int32_t> patch)
    : points_(points.begin(), points.end()), facets_(facets.begin(), facets.end()), patch_(patch.begin(), patch.end()) {
    patch_.resize(facets_.size(), 0);
    Eigen::AlignedBox3d box;
    for (const auto& t : facets_) {
        for (std::int32_t v : t) box.extend(points_[at(v)]);
    }
    diagonal_ = box.isEmpty() ? 0.0 : box.diagonal().norm();
    find_neighbours();
    measure_facets();
    build_tree();
}

void FacetTree::find_neighbours() {
    // Edges in the order of their lower vertex, then of their facets: those of one vertex are few.
    struct Side {
        std::int32_t high, facet, corner;
    };
    std::vector<std::int32_t> first(points_.size() + 1, 0);
    const auto ends = [this](std::int32_t f, std::int32_t k) {
        return std::minmax(facets_[at(f)][at(k)], facets_[at(f)][at((k + 1) % 3)]);
    };
    for (std::int32_t f = 0; f < count(); ++f) {
        for (std::int32_t k = 0; k < 3; ++k) ++first[at(ends(f, k).first) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Side> sides(3 * facets_.size());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::int32_t f = 0; f < count(); ++f) {
        for (std::int32_t k = 0; k < 3; ++k) {
            const auto [low, high] = ends(f, k);
            sides[at(next[at(low)]++)] = {high, f, k};
        }
    }
    neighbour_.assign(facets_.size(), {-1, -1, -1});
    for (std::size_t v = 0; v < points_.size(); ++v) {
        const auto begin = sides.begin() + first[v];
        const auto end = sides.begin() + first[v + 1];
        std::sort(begin, end, [](const Side& a, const Side& b) { return std::tie(a.high, a.facet) < std::tie(b.high, b.facet); });
        for (auto a = begin; a != end; ++a) {
            const auto b = a + 1;
            if (b == end || a->high != b->high) continue;
            neighbour_[at(a->facet)][at(a->corner)] = b->facet;
            neighbour_[at(b->facet)][at(b->corner)] = a->facet;
        }
    }
}

void FacetTree::measure_facets() {
    near2_.reserve(facets_.size());
    for (const auto& t : facets_) {
        const Vector3d a = points_[at(t[1])] - points_[at(t[0])];
        const Vector3d b = points_[at(t[2])] - points_[at(t[0])];
        const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        const double height = longest2 > 0.0 ? a.cross(b).norm() / std::sqrt(longest2) : 0.0;
        const double near = std::min(kNearOfHeight * height, kNearOfDiagonal * diagonal_);
        near2_.push_back(static_cast<float>(near * near));
    }
}

void FacetTree::build_tree() {
    order_.resize(facets_.size());
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.clear();
    if (facets_.empty()) return;
    nodes_.reserve(facets_.size());
    std::vector<Vector3d> middle(facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const auto& [a, b, c] = facets_[f];
        middle[f] = (points_[at(a)] + points_[at(b)] + points_[at(c)]) / 3.0;
    }
    struct Task {
        std::int32_t first, last, parent;  ///< parent: the node whose right child this is, -1 = a left child
    };
    std::vector<Task> tasks{{0, count(), -1}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto index = static_cast<std::int32_t>(nodes_.size());
        if (task.parent >= 0) nodes_[at(task.parent)].first = index;
        Eigen::AlignedBox3d box;
        Eigen::AlignedBox3d middles;
        Node node;
        node.patch = patch_[at(order_[at(task.first)])];
        for (std::int32_t i = task.first; i < task.last; ++i) {
            const std::int32_t f = order_[at(i)];
            for (std::int32_t v : facets_[at(f)]) box.extend(points_[at(v)]);
            middles.extend(middle[at(f)]);
            if (patch_[at(f)] != node.patch) node.patch = kAnyPatch;
        }
        node.low = box.min();
        node.high = box.max();
        node.first = task.first;
        if (task.last - task.first > kLeafSize) {
            Eigen::Index axis = 0;
            middles.sizes().maxCoeff(&axis);
            const std::int32_t half = task.first + (task.last - task.first) / 2;
            std::nth_element(order_.begin() + task.first, order_.begin() + half, order_.begin() + task.last,
                             [&](std::int32_t a, std::int32_t b) {
                                 const double x = middle[at(a)][axis];
                                 const double y = middle[at(b)][axis];
                                 return x != y ? x < y : a < b;
                             });
            tasks.push_back({half, task.last, index});
            tasks.push_back({task.first, half, -1});
        } else {
            node.count = task.last - task.first;
        }
        nodes_.push_back(node);
    }
}

void FacetTree::try_facet(const Point& p, std::int32_t facet, std::int32_t patch, Hit& best) const {
    if (patch != kAnyPatch && patch_[at(facet)] != patch) return;
    const auto& [a, b, c] = facets_[at(facet)];
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
        const Vector3d weights = best.weights;
        // Across the edges that the point lies on: the one from corner k to k + 1 has no weight at k + 2.
        for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t other = neighbour_[at(facet)][at(k)];
            if (weights[(k + 2) % 3] == 0.0 && other >= 0 && other != before) try_facet(p, other, patch, best);
            if (weights[k] == 1.0 && best.facet == facet) try_round(p, facets_[at(facet)][at(k)], facet, patch, best);
        }
        if (best.facet == facet) return best.distance2 <= near2_[at(facet)];
        before = facet;
    }
    return false;
}

/// All facets round a corner, which may be closer though the ones beside the first are not.
void FacetTree::try_round(const Point& p, std::int32_t corner, std::int32_t first, std::int32_t patch, Hit& best) const {
    for (const int way : {0, 2}) {
        std::int32_t facet = first;
        for (int step = 0; step < kWalkLimit; ++step) {
            const auto& t = facets_[at(facet)];
            const int k = t[0] == corner ? 0 : (t[1] == corner ? 1 : 2);
            facet = neighbour_[at(facet)][at((k + way) % 3)];
            if (facet == first) return;
            if (facet < 0) break;
            try_facet(p, facet, patch, best);
        }
    }
}

namespace {

FacetTree::Hit none() { return {std::numeric_limits<double>::infinity(), -1, Point::Zero(), Vector3d::Zero()}; }

}  // namespace

FacetTree::Hit FacetTree::closest(const Point& p, std::int32_t patch, std::int32_t hint) const {
    Hit best = none();
    if (hint >= 0 && hint < count() && walk(p, patch, hint, best)) return best;
    search(p, patch, best);
    return best;
}

FacetTree::Hit FacetTree::closest_or_within(const Point& p, std::int32_t patch, std::int32_t hint, double enough2) const {
    Hit best = none();
    if (hint >= 0 && hint < count()) walk(p, patch, hint, best);
    if (best.distance2 > enough2) search(p, patch, best);
    return best;
}

/// The closest point of all facets, if it is closer than the best one so far.
void FacetTree::search(const Point& p, std::int32_t patch, Hit& best) const {
    if (nodes_.empty()) return;
    struct Entry {
        std::int32_t node;
        double distance2;
    };
    std::array<Entry, kStackSize> stack;
    int top = 0;
    stack[0] = {0, 0.0};
    while (top >= 0) {
        const Entry entry = stack[at(top--)];
        // Equally close boxes are opened too, and those that rounding alone makes farther: of equally close facets the lowest
        // index wins, whatever came first.
        if (entry.distance2 > best.distance2 * kRounding) continue;
        const Node& node = nodes_[at(entry.node)];
        if (patch != kAnyPatch && node.patch != kAnyPatch && node.patch != patch) continue;
        if (node.count > 0) {
            for (std::int32_t i = 0; i < node.count; ++i) try_facet(p, order_[at(node.first + i)], patch, best);
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
