#include "surface/reference_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "surface/closest_on_triangle.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLeafSize = 4;
constexpr int kStackSize = 96;  ///< median splits halve: the depth is below 40
constexpr int kWalkLimit = 64;      ///< facets
constexpr double kNear = 0.05;      ///< distance over the size of a facet at which a walk's end needs no search
constexpr double kRounding = 1.0 + 1e-12;
constexpr double kLiftOfHeight = 0.1;  ///< limits of the lift off a facet
constexpr double kLiftOfDiagonal = 5e-4;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double distance2_to_box(const Point& p, const Vector3d& low, const Vector3d& high) {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

ReferenceSurface::ReferenceSurface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                                   std::span<const std::int32_t> facet_patch, double crease_angle)
    : points_(points.begin(), points.end()),
      facets_(triangles.begin(), triangles.end()),
      patch_(facet_patch.begin(), facet_patch.end()) {
    patch_.resize(facets_.size(), 0);
    Eigen::AlignedBox3d box;
    for (const auto& t : facets_) {
        for (std::int32_t v : t) box.extend(points_[at(v)]);
    }
    diagonal_ = box.isEmpty() ? 0.0 : box.diagonal().norm();
    find_neighbours();
    compute_normals(crease_angle);
    build_tree();
}

void ReferenceSurface::find_neighbours() {
    // Edges in the order of their lower vertex, then of their facets: those of one vertex are few.
    struct Side {
        std::int32_t high, facet, corner;
    };
    std::vector<std::int32_t> first(points_.size() + 1, 0);
    const auto ends = [this](std::int32_t f, std::int32_t k) {
        return std::minmax(facets_[at(f)][at(k)], facets_[at(f)][at((k + 1) % 3)]);
    };
    for (std::int32_t f = 0; f < facet_count(); ++f) {
        for (std::int32_t k = 0; k < 3; ++k) ++first[at(ends(f, k).first) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Side> sides(3 * facets_.size());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::int32_t f = 0; f < facet_count(); ++f) {
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

void ReferenceSurface::compute_normals(double crease_angle) {
    facet_normal_.resize(facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const auto& [a, b, c] = facets_[f];
        facet_normal_[f] = (points_[at(b)] - points_[at(a)]).cross(points_[at(c)] - points_[at(a)]).stableNormalized();
    }
    const double crease = std::cos(crease_angle * std::numbers::pi / 180.0);
    const auto corner_of = [this](std::int32_t facet, std::int32_t v) {
        const auto& t = facets_[at(facet)];
        return t[0] == v ? 0 : (t[1] == v ? 1 : 2);
    };
    std::vector<std::array<double, 3>> angle(facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const auto& t = facets_[f];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d a = points_[at(t[(k + 1) % 3])] - points_[at(t[k])];
            const Vector3d b = points_[at(t[(k + 2) % 3])] - points_[at(t[k])];
            angle[f][k] = std::atan2(a.cross(b).norm(), a.dot(b));
        }
    }
    const auto weighted = [&](std::int32_t facet, int k) -> Vector3d { return angle[at(facet)][at(k)] * facet_normal_[at(facet)]; };
    corner_normal_.resize(facets_.size());
    for (std::int32_t f = 0; f < facet_count(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t v = facets_[at(f)][at(k)];
            Vector3d sum = weighted(f, k);
            // Both ways round the vertex until an edge separates; a closed fan is done after the first way.
            bool full_turn = false;
            for (int way = 0; way < 2 && !full_turn; ++way) {
                std::int32_t facet = f;
                for (std::int32_t guard = 0; guard < facet_count(); ++guard) {
                    const int corner = corner_of(facet, v);
                    const std::int32_t across = neighbour_[at(facet)][at(way == 0 ? (corner + 2) % 3 : corner)];
                    if (across < 0 || patch_[at(across)] != patch_[at(f)] ||
                        facet_normal_[at(across)].dot(facet_normal_[at(facet)]) < crease) {
                        break;
                    }
                    if (across == f) {
                        full_turn = true;
                        break;
                    }
                    sum += weighted(across, corner_of(across, v));
                    facet = across;
                }
            }
            corner_normal_[at(f)][at(k)] = sum.norm() > 0.0 ? Vector3d(sum.normalized()) : facet_normal_[at(f)];
        }
    }
}

void ReferenceSurface::build_tree() {
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
    std::vector<Task> tasks{{0, facet_count(), -1}};
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

void ReferenceSurface::try_facet(const Point& p, std::int32_t facet, std::int32_t patch, Candidate& best) const {
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
/// @returns true if the point found is near for the facet's size: then it is the closest one of this sheet of the surface, and
///          closer ones of another sheet are not wanted
bool ReferenceSurface::walk(const Point& p, std::int32_t patch, std::int32_t hint, Candidate& best) const {
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
        if (best.facet == facet) return best.distance2 <= kNear * kNear * extent2(facet);
        before = facet;
    }
    return false;
}

/// All facets round a corner, which may be closer though the ones beside the first are not.
void ReferenceSurface::try_round(const Point& p, std::int32_t corner, std::int32_t first, std::int32_t patch, Candidate& best) const {
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

double ReferenceSurface::extent2(std::int32_t facet) const {
    const auto& t = facets_[at(facet)];
    return (points_[at(t[1])] - points_[at(t[0])]).squaredNorm();
}

ReferenceSurface::Candidate ReferenceSurface::search(const Point& p, std::int32_t patch, std::int32_t hint) const {
    Candidate best{std::numeric_limits<double>::infinity(), -1, Point::Zero(), Vector3d::Zero()};
    if (nodes_.empty()) return best;
    if (hint >= 0 && hint < facet_count() && walk(p, patch, hint, best)) return best;

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
    return best;
}

Vector3d ReferenceSurface::interpolated_normal(const Candidate& c) const {
    const auto& n = corner_normal_[at(c.facet)];
    const Vector3d sum = c.weights[0] * n[0] + c.weights[1] * n[1] + c.weights[2] * n[2];
    return sum.norm() > 0.0 ? Vector3d(sum.normalized()) : facet_normal_[at(c.facet)];
}

SurfacePoint ReferenceSurface::closest(const Point& p, std::int32_t patch) const { return closest(p, patch, -1); }

SurfacePoint ReferenceSurface::closest(const Point& p, std::int32_t patch, std::int32_t hint) const {
    const Candidate c = search(p, patch, hint);
    if (c.facet < 0) return {};
    return {c.position, c.facet, std::sqrt(c.distance2), interpolated_normal(c)};
}

Point ReferenceSurface::project(const Point& p, std::int32_t patch, std::int32_t& hint) const {
    const Candidate c = search(p, patch, hint);
    if (c.facet < 0) return p;
    hint = c.facet;
    const auto& t = facets_[at(c.facet)];
    Vector3d lift = Vector3d::Zero();
    double longest = 0.0;
    for (std::int32_t k = 0; k < 3; ++k) {
        const Point& corner = points_[at(t[at(k)])];
        const Vector3d& n = corner_normal_[at(c.facet)][at(k)];
        lift += 0.5 * c.weights[k] * (corner - c.position).dot(n) * n;
        longest = std::max(longest, (points_[at(t[at((k + 1) % 3)])] - corner).norm());
    }
    const double area2 = (points_[at(t[1])] - points_[at(t[0])]).cross(points_[at(t[2])] - points_[at(t[0])]).norm();
    const double limit = std::min(kLiftOfHeight * area2 / longest, kLiftOfDiagonal * diagonal_);
    const double length = lift.norm();
    if (!(length > 0.0) || !(limit > 0.0)) return c.position;
    return c.position + std::min(1.0, limit / length) * lift;
}

}  // namespace anisoquad
