#include "input/weld_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

constexpr double kOfDiagonal = 1e-7;
constexpr double kOfEdge = 0.05;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Vertices in the cells of a grid, sorted by cell; the cells are larger than the tolerance.
class Places {
  public:
    explicit Places(const TriangleSoup& soup)
        : soup_(soup), shortest_(soup.points.size(), std::numeric_limits<double>::infinity()) {
        Point low = Point::Constant(std::numeric_limits<double>::infinity());
        Point high = -low;
        for (const auto& t : soup.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double length = (soup.point(t[k]) - soup.point(t[(k + 1) % 3])).norm();
                for (const std::int32_t v : {t[k], t[(k + 1) % 3]}) {
                    if (length > 0.0) shortest_[at(v)] = std::min(shortest_[at(v)], length);
                }
                low = low.cwiseMin(soup.point(t[k]));
                high = high.cwiseMax(soup.point(t[k]));
            }
        }
        if (soup.triangles.empty()) return;
        // A model far from the origin has lost digits: a few units in the last place are no distance.
        const double rounding =
            4.0 * std::numeric_limits<double>::epsilon() * std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
        // The typical edge bounds it too, or all of a small part beside a large one would lie in a single cell.
        tolerance_ = std::max(std::min(kOfDiagonal * (high - low).norm(), kOfEdge * median_shortest()), rounding);
        for (std::int32_t v = 0; v < static_cast<std::int32_t>(soup.points.size()); ++v) {
            // Vertices without an edge of any length are of no use.
            if (std::isfinite(shortest_[at(v)])) entries_.push_back({cell((soup.point(v) - low) / (4.0 * tolerance_)), v});
        }
        std::sort(entries_.begin(), entries_.end());
        low_ = low;
    }

    std::vector<std::int32_t> find() const {
        std::vector<std::int32_t> place(soup_.points.size());
        for (std::size_t v = 0; v < place.size(); ++v) place[v] = static_cast<std::int32_t>(v);
        std::vector<std::int32_t> used;
        for (const Entry& entry : entries_) used.push_back(entry.vertex);
        std::sort(used.begin(), used.end());
        // Each vertex that is free gathers those around it: chains of near vertices do not drift away.
        std::vector<char> taken(soup_.points.size(), 0);
        for (const std::int32_t v : used) {
            if (taken[at(v)]) continue;
            taken[at(v)] = 1;
            for_each_near(v, [&](std::int32_t w) {
                if (taken[at(w)]) return;
                taken[at(w)] = 1;
                place[at(w)] = v;
            });
        }
        return place;
    }

  private:
    using Cell = std::array<double, 3>;  // whole numbers; what no integer type could hold is no trouble
    struct Entry {
        Cell cell;
        std::int32_t vertex;
        bool operator<(const Entry& other) const { return cell != other.cell ? cell < other.cell : vertex < other.vertex; }
    };

    double median_shortest() const {
        std::vector<double> lengths;
        for (const double length : shortest_) {
            if (std::isfinite(length)) lengths.push_back(length);
        }
        if (lengths.empty()) return 0.0;
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        return *middle;
    }

    static Cell cell(const Point& p) { return {std::floor(p.x()), std::floor(p.y()), std::floor(p.z())}; }

    template <class Function>
    void for_each_near(std::int32_t v, Function f) const {
        const Point p = soup_.point(v);
        const Point reach = Point::Constant(tolerance_);
        const Cell first = cell((p - reach - low_) / (4.0 * tolerance_));
        const Cell last = cell((p + reach - low_) / (4.0 * tolerance_));
        for (const double x : {first[0], last[0]}) {
            for (const double y : {first[1], last[1]}) {
                for (const double z : {first[2], last[2]}) {
                    auto entry = std::lower_bound(entries_.begin(), entries_.end(), Entry{{x, y, z}, 0});
                    for (; entry != entries_.end() && entry->cell == Cell{x, y, z}; ++entry) {
                        const std::int32_t w = entry->vertex;
                        const double bound = std::min(tolerance_, kOfEdge * std::min(shortest_[at(v)], shortest_[at(w)]));
                        if ((soup_.point(w) - p).norm() <= bound) f(w);
                    }
                }
            }
        }
    }

    const TriangleSoup& soup_;
    std::vector<double> shortest_;  ///< per vertex: its shortest edge that has a length
    double tolerance_ = 0.0;
    Point low_ = Point::Zero();
    std::vector<Entry> entries_;
};

}  // namespace

std::vector<std::int32_t> points_at_one_place(const TriangleSoup& soup) { return Places(soup).find(); }

std::int32_t weld_open_edges(TriangleSoup& soup, std::span<const std::int32_t> place) {
    std::vector<char> open(soup.points.size(), 0);
    const std::vector<DirectedEdge> edges = sorted_edges(soup.points.size(), soup.triangles);
    for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
        if (edge.size() == 1) open[at(edge[0].low)] = open[at(edge[0].high)] = 1;
    });
    // The lowest open vertex of a place stands for the others; a closed one there keeps to itself.
    std::vector<std::int32_t> first(soup.points.size(), -1);
    std::int32_t welded = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (!open[v]) continue;
        std::int32_t& kept = first[at(place[v])];
        if (kept < 0) {
            kept = static_cast<std::int32_t>(v);
        } else {
            soup.merge(kept, static_cast<std::int32_t>(v));
            ++welded;
        }
    }
    soup.apply_merges();
    return welded;
}

}  // namespace anisoquad
