#include <algorithm>

#include "input/facet_mates.h"
#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class VertexSplitter {
  public:
    VertexSplitter(TriangleSoup& soup, std::vector<std::int32_t>& mate) : soup_(soup), mate_(mate) {}

    std::int32_t run() {
        const auto before = soup_.points.size();
        split_fans();
        while (halve_doubled_edges()) {
        }
        return static_cast<std::int32_t>(soup_.points.size() - before);
    }

  private:
    void split_fans() {
        std::vector<char> seen(mate_.size(), 0);
        std::vector<char> used(soup_.points.size(), 0);
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(mate_.size()); ++c) {
            if (seen[at(c)]) continue;
            const std::int32_t v = soup_.vertex(c);
            std::int32_t own = v;
            if (used[at(v)]) {
                const Point p = soup_.point(v);
                own = soup_.add_vertex(p, soup_.origin[at(v)]);
            }
            used[at(v)] = 1;
            const auto take = [&](std::int32_t k) {
                seen[at(k)] = 1;
                soup_.triangles[at(k / 3)][at(k % 3)] = own;
            };
            for (std::int32_t k = c; k >= 0 && !seen[at(k)]; k = mate_[at(previous_corner(k))]) take(k);
            for (std::int32_t k = mate_[at(c)]; k >= 0 && !seen[at(next_corner(k))]; k = mate_[at(next_corner(k))])
                take(next_corner(k));
        }
    }

    /// Two edges between the same vertices (the sides of a cut one edge long, sheets that touch along an edge only): all but
    /// the first get a vertex in their middle. Each round does those whose facets have not been changed in it.
    bool halve_doubled_edges() {
        std::vector<std::int32_t> doubled;
        const std::vector<DirectedEdge> edges = sorted_edges(soup_.points.size(), soup_.triangles);
        for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
            const std::int32_t first = edge[0].corner;
            for (const DirectedEdge& e : edge) {
                const bool second_half = mate_[at(e.corner)] >= 0 && mate_[at(e.corner)] < e.corner;
                if (e.corner != first && e.corner != mate_[at(first)] && !second_half) doubled.push_back(e.corner);
            }
        });
        touched_.assign(soup_.triangles.size(), 0);
        for (const std::int32_t c : doubled) {
            const std::int32_t other = mate_[at(c)];
            if (touched_[at(c / 3)] || (other >= 0 && touched_[at(other / 3)])) continue;
            halve(c, other);
        }
        return !doubled.empty();
    }

    void halve(std::int32_t c, std::int32_t other) {
        const Point middle = 0.5 * (soup_.point(soup_.vertex(c)) + soup_.point(soup_.vertex(next_corner(c))));
        const std::int32_t v = soup_.add_vertex(middle, -1);
        const std::int32_t ahead = cut(c, v);
        if (other < 0) return;
        const std::int32_t ahead_other = cut(other, v);
        pair(c, ahead_other);
        pair(other, ahead);
    }

    /// Cuts the facet p, q, r of a corner at p into p, v, r and v, q, r. @returns the corner at v of the second
    std::int32_t cut(std::int32_t c, std::int32_t v) {
        const std::int32_t next = next_corner(c);
        const std::int32_t q = soup_.vertex(next);
        const std::int32_t r = soup_.vertex(previous_corner(c));
        const std::int32_t first = 3 * soup_.facet_count();
        soup_.triangles[at(next / 3)][at(next % 3)] = v;
        soup_.triangles.push_back({v, q, r});
        mate_.insert(mate_.end(), {-1, -1, -1});
        touched_[at(c / 3)] = 1;
        touched_.push_back(1);
        pair(first + 1, mate_[at(next)]);
        pair(first + 2, next);
        mate_[at(c)] = -1;
        return first;
    }

    void pair(std::int32_t a, std::int32_t b) {
        mate_[at(a)] = b;
        if (b >= 0) mate_[at(b)] = a;
    }

    TriangleSoup& soup_;
    std::vector<std::int32_t>& mate_;
    std::vector<char> touched_;
};

}  // namespace

std::int32_t split_vertices(TriangleSoup& soup, std::vector<std::int32_t>& mate) { return VertexSplitter(soup, mate).run(); }

}  // namespace anisoquad
