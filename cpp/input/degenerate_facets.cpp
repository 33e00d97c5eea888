#include "input/degenerate_facets.h"

#include <algorithm>
#include <vector>

#include "input/drop_facets.h"
#include "input/flatness.h"
#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

constexpr double kMargin = 4.0;   // over what the check accepts, so that rounding does not decide
constexpr double kNeedle = 1e-6;  // shortest edge over the longest: below it the facet is a needle, not a cap
constexpr int kRounds = 50;       // mending can make further degenerate facets; what is left after that is removed

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class DegenerateMender {
  public:
    explicit DegenerateMender(TriangleSoup& soup) : soup_(soup), diagonal_(diagonal(soup.points, soup.triangles)) {}

    std::int32_t run() {
        std::int32_t mended = 0;
        for (int round = 0; round < kRounds; ++round) {
            const std::int32_t found = mend_once();
            if (found == 0) return mended;
            mended += found;
        }
        return mended + static_cast<std::int32_t>(std::erase_if(soup_.triangles, [&](const Triangle& t) { return is_flat(t); }));
    }

  private:
    using Triangle = std::array<std::int32_t, 3>;

    bool is_flat(const Triangle& t) const {
        return is_degenerate(soup_.point(t[0]), soup_.point(t[1]), soup_.point(t[2]), diagonal_, kMargin);
    }
    bool is_point(const Triangle& t) const {
        return !(std::max({length(t[0], t[1]), length(t[1], t[2]), length(t[2], t[0])}) > kMargin * kNoSize * diagonal_);
    }

    /// Mends the facets that are degenerate now and have no neighbour that was mended before them.
    std::int32_t mend_once() {
        std::vector<std::int32_t> flat;
        for (std::int32_t f = 0; f < soup_.facet_count(); ++f) {
            if (is_flat(soup_.triangles[at(f)])) flat.push_back(f);
        }
        if (flat.empty()) return 0;
        edges_ = sorted_edges(soup_.points.size(), soup_.triangles);
        touched_.assign(soup_.triangles.size(), 0);
        gone_.assign(soup_.triangles.size(), 0);
        std::int32_t mended = 0;
        for (const std::int32_t f : flat) mended += !touched_[at(f)] && mend(f);
        soup_.triangles.insert(soup_.triangles.end(), added_.begin(), added_.end());
        added_.clear();
        std::size_t f = 0;
        std::erase_if(soup_.triangles, [&](const Triangle&) { return f < gone_.size() ? gone_[f++] != 0 : false; });
        soup_.apply_merges();
        drop_repeated_corners(soup_);
        drop_duplicates(soup_);
        return mended;
    }

    bool mend(std::int32_t f) {
        const Triangle t = soup_.triangles[at(f)];
        if (is_point(t)) {
            soup_.merge(t[0], t[1]);
            soup_.merge(t[0], t[2]);
            remove(f);
            return true;
        }
        // The longest edge runs from a to b, the corner c lies beside it.
        std::size_t longest = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (length(t[k], t[(k + 1) % 3]) > length(t[longest], t[(longest + 1) % 3])) longest = k;
        }
        const std::int32_t a = t[longest];
        const std::int32_t b = t[(longest + 1) % 3];
        const std::int32_t c = t[(longest + 2) % 3];
        const std::int32_t near = length(a, c) <= length(b, c) ? a : b;
        if (!(length(near, c) > kNeedle * length(a, b))) {
            soup_.merge(c, near);
            remove(f);
            return true;
        }
        return mend_cap(f, a, b, c);
    }

    bool mend_cap(std::int32_t f, std::int32_t a, std::int32_t b, std::int32_t c) {
        const std::span<const DirectedEdge> across = facets_at(a, b);
        const bool hangs = facets_at(a, c).size() == 1 && facets_at(b, c).size() == 1;
        if (!hangs) {
            for (const DirectedEdge& e : across) {
                if (touched_[at(e.corner / 3)]) return false;
            }
            for (const DirectedEdge& e : across) {
                if (e.corner / 3 != f) cut(e.corner, c);
            }
            soup_.halved.push_back({a, b, c});
        }
        remove(f);
        return true;
    }

    /// Cuts the facet of a corner in two, at c on the edge that leaves the corner.
    void cut(std::int32_t corner, std::int32_t c) {
        const std::int32_t p = soup_.vertex(corner);
        const std::int32_t q = soup_.vertex(next_corner(corner));
        const std::int32_t r = soup_.vertex(previous_corner(corner));
        remove(corner / 3);
        if (r == c) return;  // the same three corners as the cap
        added_.push_back({p, c, r});
        added_.push_back({c, q, r});
    }

    void remove(std::int32_t f) { touched_[at(f)] = gone_[at(f)] = 1; }

    double length(std::int32_t a, std::int32_t b) const { return (soup_.point(a) - soup_.point(b)).norm(); }

    /// Directed edges between two vertices as they were at the start of the round.
    std::span<const DirectedEdge> facets_at(std::int32_t a, std::int32_t b) const {
        const auto [low, high] = std::minmax(a, b);
        const auto less = [](const DirectedEdge& e, const DirectedEdge& f) {
            return e.low != f.low ? e.low < f.low : e.high < f.high;
        };
        const auto [first, last] = std::equal_range(edges_.begin(), edges_.end(), DirectedEdge{low, high, 0}, less);
        return {first, last};
    }

    TriangleSoup& soup_;
    double diagonal_;
    std::vector<DirectedEdge> edges_;
    std::vector<char> touched_;
    std::vector<char> gone_;
    std::vector<Triangle> added_;
};

}  // namespace

std::int32_t mend_degenerate_facets(TriangleSoup& soup) { return DegenerateMender(soup).run(); }

}  // namespace anisoquad
