#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "input/facet_mates.h"
#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

constexpr std::size_t kMostFacets = 64;  // at one edge: more are all cut apart

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A facet at an edge with several: its direction around the edge, and whether it runs along it from the lower vertex up.
struct Leaf {
    double angle;
    std::int32_t corner;
    bool up;
};

class FacetPairing {
  public:
    explicit FacetPairing(const TriangleSoup& soup) : soup_(soup), mate_(3 * soup.triangles.size(), -1) {}

    std::vector<std::int32_t> run(std::int32_t& cut) {
        const std::vector<DirectedEdge> edges = sorted_edges(soup_.points.size(), soup_.triangles);
        for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() == 2) join(edge[0].corner, edge[1].corner);
            if (edge.size() <= 2) return;
            ++cut;
            if (edge.size() <= kMostFacets) pair_leaves(edge);
        });
        return std::move(mate_);
    }

  private:
    void join(std::int32_t a, std::int32_t b) {
        mate_[at(a)] = b;
        mate_[at(b)] = a;
    }

    void pair_leaves(std::span<const DirectedEdge> edge) {
        const Point& p = soup_.point(edge[0].low);
        const Eigen::Vector3d axis = (soup_.point(edge[0].high) - p).normalized();
        const Eigen::Vector3d zero = (soup_.point(soup_.vertex(previous_corner(edge[0].corner))) - p).cross(axis);
        leaves_.clear();
        std::size_t up = 0;
        for (const DirectedEdge& e : edge) {
            const Eigen::Vector3d side = (soup_.point(soup_.vertex(previous_corner(e.corner))) - p).cross(axis);
            const double angle = std::atan2(zero.cross(side).dot(axis), zero.dot(side));
            leaves_.push_back({angle, e.corner, soup_.vertex(e.corner) == e.low});
            up += leaves_.back().up;
        }
        std::sort(leaves_.begin(), leaves_.end(),
                  [](const Leaf& a, const Leaf& b) { return std::tie(a.angle, a.corner) < std::tie(b.angle, b.corner); });
        if (2 * up == leaves_.size()) {
            pair_insides();
        } else {
            pair_flattest();
        }
    }

    /// The inside of a solid begins, in the sense of growing angles, behind a facet that runs down and ends at one that runs
    /// up: like brackets, round the edge.
    void pair_insides() {
        std::vector<std::int32_t> begun;
        for (std::size_t i = 0; i < 2 * leaves_.size(); ++i) {
            const Leaf& leaf = leaves_[i % leaves_.size()];
            if (mate_[at(leaf.corner)] >= 0) continue;
            if (!leaf.up) {
                if (i < leaves_.size()) begun.push_back(leaf.corner);
            } else if (!begun.empty()) {
                join(begun.back(), leaf.corner);
                begun.pop_back();
            }
        }
    }

    void pair_flattest() {
        struct Pair {
            double turn;
            std::size_t a;
            std::size_t b;
        };
        std::vector<Pair> pairs;
        const bool all_alike = std::all_of(leaves_.begin(), leaves_.end(), [&](const Leaf& l) { return l.up == leaves_[0].up; });
        for (std::size_t a = 0; a < leaves_.size(); ++a) {
            for (std::size_t b = a + 1; b < leaves_.size(); ++b) {
                if (!all_alike && leaves_[a].up == leaves_[b].up) continue;
                pairs.push_back({std::abs(std::numbers::pi - std::abs(leaves_[a].angle - leaves_[b].angle)), a, b});
            }
        }
        std::sort(pairs.begin(), pairs.end(),
                  [](const Pair& x, const Pair& y) { return std::tie(x.turn, x.a, x.b) < std::tie(y.turn, y.a, y.b); });
        for (const Pair& pair : pairs) {
            const std::int32_t a = leaves_[pair.a].corner;
            const std::int32_t b = leaves_[pair.b].corner;
            if (mate_[at(a)] < 0 && mate_[at(b)] < 0) join(a, b);
        }
    }

    const TriangleSoup& soup_;
    std::vector<std::int32_t> mate_;
    std::vector<Leaf> leaves_;
};

}  // namespace

std::vector<std::int32_t> pair_facets(const TriangleSoup& soup, std::int32_t& cut) { return FacetPairing(soup).run(cut); }

}  // namespace anisoquad
