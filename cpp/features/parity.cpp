#include "features/parity.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/face_components.h"
#include "mesh/quad_chord.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kChord = 10.0;  // a column or a row of quads is halved only where no single edge helps

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Components of unmeshed triangles and the parity of their boundaries.
struct Components : FaceComponents {
    std::vector<std::int32_t> edges;  ///< boundary edges of each component

    explicit Components(const SurfaceMesh& mesh)
        : FaceComponents(face_components(
              mesh, [&](Face f) { return mesh.is_triangle(f); }, [&](Edge e) { return !mesh.is_constrained(e); })),
          edges(first.size(), 0) {
        const auto component = [&](HalfEdge h) { return mesh.is_boundary(h) ? -1 : of_face[at(mesh.face(h).index())]; };
        for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
            const Edge e(i);
            if (mesh.is_deleted(e)) continue;
            const std::int32_t a = component(M::halfedge(e, 0));
            const std::int32_t b = component(M::halfedge(e, 1));
            if (a >= 0 && b >= 0 && !mesh.is_constrained(e)) continue;
            if (a >= 0) ++edges[at(a)];
            if (b >= 0) ++edges[at(b)];
        }
    }

    bool is_odd(std::int32_t component) const { return edges[at(component)] % 2 != 0; }
};

class ParityMaker {
  public:
    explicit ParityMaker(SurfaceMesh& mesh) : mesh_(mesh), components_(mesh), outside_(components_.count()) {}

    ParityResult run() {
        for (std::int32_t c = 0; c < outside_; ++c) result_.odd += components_.is_odd(c);
        if (result_.odd == 0) return std::move(result_);
        find_links();
        choose_terminals();
        grow_regions();
        join_terminals();
        split_links();
        return std::move(result_);
    }

  private:
    /// The cheapest edge that two components, or a component and outside, share, or chord of quads between them.
    struct Link {
        std::int32_t a;
        std::int32_t b;
        double cost;
        HalfEdge start;  ///< in a component, or outside
        std::int32_t other(std::int32_t node) const { return node == a ? b : a; }
    };

    /// Component on that side, outside_ for nothing, -1 for a quad.
    std::int32_t node(HalfEdge h) const {
        return mesh_.is_boundary(h) ? outside_ : components_.of_face[at(mesh_.face(h).index())];
    }

    /// Every split costs 1, and more the shorter the edge is compared with the mean of the line edges that it touches.
    double cost(Edge e) const {
        double sum = 0.0;
        int n = 0;
        for (const HalfEdge h : {M::halfedge(e, 0), M::halfedge(e, 1)}) {
            for (const HalfEdge out : mesh_.outgoing(mesh_.from(h))) {
                if (M::edge(out) == e || !mesh_.is_constrained(M::edge(out))) continue;
                sum += mesh_.length(out);
                ++n;
            }
        }
        const double ratio = n > 0 ? sum / (n * mesh_.length(e)) : 1.0;
        const double source = mesh_.info(e).source ? 4.0 : 0.0;
        return 1.0 + std::min(ratio, 4.0) + source;
    }

    double chord_cost(HalfEdge start, HalfEdge end, int quads) const {
        if (quads == 0) return cost(M::edge(start));
        return kChord + 0.5 * quads + std::max(cost(M::edge(start)), cost(M::edge(end)));
    }

    void find_links() {
        for (std::int32_t i = 0; i < mesh_.halfedge_slots(); ++i) {
            const HalfEdge h(i);
            if (mesh_.is_deleted(h) || node(h) < 0) continue;
            const bool quad = !mesh_.is_boundary(M::twin(h)) && mesh_.is_quad(mesh_.face(M::twin(h)));
            if (!quad && !mesh_.is_constrained(M::edge(h))) continue;
            int quads = 0;
            const HalfEdge end = chord_end(mesh_, h, quads);
            const auto [a, b] = std::minmax({node(h), node(end)});
            if (h < end && a != b) links_.push_back({a, b, chord_cost(h, end, quads), h});
        }
        std::sort(links_.begin(), links_.end(), [](const Link& x, const Link& y) {
            return std::tie(x.a, x.b, x.cost, x.start) < std::tie(y.a, y.b, y.cost, y.start);
        });
        const auto same_pair = [](const Link& x, const Link& y) { return x.a == y.a && x.b == y.b; };
        links_.erase(std::unique(links_.begin(), links_.end(), same_pair), links_.end());
        start_.assign(at(outside_) + 2, 0);
        for (const Link& link : links_) {
            ++start_[at(link.a) + 1];
            ++start_[at(link.b) + 1];
        }
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        incident_.resize(2 * links_.size());
        std::vector<std::int32_t> fill(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < links_.size(); ++i) {
            for (const std::int32_t n : {links_[i].a, links_[i].b}) incident_[at(fill[at(n)]++)] = static_cast<std::int32_t>(i);
        }
    }

    /// The odd components; outside too where that makes their number even, or else one of them has to be left odd.
    void choose_terminals() {
        DisjointSets sets(outside_ + 1);
        for (const Link& link : links_) sets.unite(link.a, link.b);
        std::vector<std::int32_t> pending(at(outside_) + 1, -1);  // per set: an odd component without a partner
        for (std::int32_t c = 0; c < outside_; ++c) {
            if (!components_.is_odd(c)) continue;
            std::int32_t& partner = pending[at(sets.find(c))];
            if (partner >= 0) {
                terminals_.insert(terminals_.end(), {partner, c});
                partner = -1;
            } else {
                partner = c;
            }
        }
        for (std::int32_t s = 0; s <= outside_; ++s) {
            const std::int32_t c = pending[at(s)];
            if (c < 0) continue;
            if (sets.find(outside_) == s) {
                terminals_.insert(terminals_.end(), {c, outside_});
            } else {
                result_.left.push_back(mesh_.info(components_.first[at(c)]).patch);
            }
        }
        std::sort(terminals_.begin(), terminals_.end());
    }

    /// Shortest ways (Dijkstra) from every node to its nearest terminal.
    void grow_regions() {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        distance_.assign(at(outside_) + 1, kFar);
        region_.assign(at(outside_) + 1, -1);
        way_.assign(at(outside_) + 1, -1);
        using Entry = std::pair<double, std::int32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        for (std::size_t t = 0; t < terminals_.size(); ++t) {
            distance_[at(terminals_[t])] = 0.0;
            region_[at(terminals_[t])] = static_cast<std::int32_t>(t);
            queue.emplace(0.0, terminals_[t]);
        }
        while (!queue.empty()) {
            const auto [d, n] = queue.top();
            queue.pop();
            if (d > distance_[at(n)]) continue;
            for (std::int32_t i = start_[at(n)]; i < start_[at(n) + 1]; ++i) {
                const Link& link = links_[at(incident_[at(i)])];
                const std::int32_t m = link.other(n);
                if (!(d + link.cost < distance_[at(m)])) continue;
                distance_[at(m)] = d + link.cost;
                region_[at(m)] = region_[at(n)];
                way_[at(m)] = incident_[at(i)];
                queue.emplace(distance_[at(m)], m);
            }
        }
    }

    /// Joins the terminals in pairs along a minimum spanning tree of their regions: a T-join of all of them.
    void join_terminals() {
        struct Bridge {
            double cost;
            std::int32_t link;
            bool operator<(const Bridge& other) const { return std::tie(cost, link) < std::tie(other.cost, other.link); }
        };
        std::vector<Bridge> bridges;
        for (std::size_t i = 0; i < links_.size(); ++i) {
            const Link& link = links_[i];
            const std::int32_t a = region_[at(link.a)];
            const std::int32_t b = region_[at(link.b)];
            if (a >= 0 && b >= 0 && a != b)
                bridges.push_back({distance_[at(link.a)] + link.cost + distance_[at(link.b)], static_cast<std::int32_t>(i)});
        }
        std::sort(bridges.begin(), bridges.end());
        const auto n = static_cast<std::int32_t>(terminals_.size());
        DisjointSets sets(n);
        std::vector<std::vector<std::int32_t>> tree(at(n));  // links at each terminal's region
        for (const Bridge& bridge : bridges) {
            const std::int32_t a = region_[at(links_[at(bridge.link)].a)];
            const std::int32_t b = region_[at(links_[at(bridge.link)].b)];
            if (!sets.unite(a, b)) continue;
            tree[at(a)].push_back(bridge.link);
            tree[at(b)].push_back(bridge.link);
        }
        // A branch with an odd number of terminals has to be joined to the rest. Leaves are cut off one after the other.
        used_.assign(links_.size(), 0);
        std::vector<char> odd(at(n), 1);
        std::vector<std::int32_t> degree(at(n));
        std::vector<char> cut(links_.size(), 0);
        std::vector<std::int32_t> leaves;
        for (std::int32_t t = 0; t < n; ++t) {
            degree[at(t)] = static_cast<std::int32_t>(tree[at(t)].size());
            if (degree[at(t)] == 1) leaves.push_back(t);
        }
        while (!leaves.empty()) {
            const std::int32_t t = leaves.back();
            leaves.pop_back();
            for (const std::int32_t i : tree[at(t)]) {
                if (cut[at(i)]) continue;
                cut[at(i)] = 1;
                const std::int32_t a = region_[at(links_[at(i)].a)];
                const std::int32_t parent = a == t ? region_[at(links_[at(i)].b)] : a;
                if (--degree[at(parent)] == 1) leaves.push_back(parent);
                if (!odd[at(t)]) continue;
                odd[at(t)] = 0;
                odd[at(parent)] ^= 1;
                use_way(i);
            }
        }
    }

    /// Toggles the links from terminal to terminal over link i; twice over a link is the same as never.
    void use_way(std::int32_t i) {
        used_[at(i)] ^= 1;
        for (std::int32_t n : {links_[at(i)].a, links_[at(i)].b}) {
            while (way_[at(n)] >= 0) {
                used_[at(way_[at(n)])] ^= 1;
                n = links_[at(way_[at(n)])].other(n);
            }
        }
    }

    void split_links() {
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (used_[i]) split_chord(mesh_, links_[i].start, result_.new_nodes);
        }
        result_.splits = static_cast<std::int32_t>(result_.new_nodes.size());
    }

    SurfaceMesh& mesh_;
    Components components_;
    std::int32_t outside_;  ///< node of the graph that stands for what lies beyond the boundary
    std::vector<Link> links_;
    std::vector<std::int32_t> start_;  ///< per node: first of its links in incident_
    std::vector<std::int32_t> incident_;
    std::vector<std::int32_t> terminals_;
    std::vector<double> distance_;      ///< per node: to its nearest terminal
    std::vector<std::int32_t> region_;  ///< per node: that terminal's place in terminals_
    std::vector<std::int32_t> way_;     ///< per node: link to walk towards it, -1 at the terminal
    std::vector<char> used_;
    ParityResult result_;
};

}  // namespace

ParityResult make_parity_even(SurfaceMesh& mesh) { return ParityMaker(mesh).run(); }

std::int32_t count_odd_components(const SurfaceMesh& mesh) {
    const Components components(mesh);
    std::int32_t odd = 0;
    for (std::int32_t c = 0; c < components.count(); ++c) odd += components.is_odd(c);
    return odd;
}

}  // namespace anisoquad
