#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "input/facet_mates.h"
#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Orientation {
  public:
    Orientation(TriangleSoup& soup, std::vector<std::int32_t>& mate)
        : soup_(soup), mate_(mate), chart_(soup.triangles.size(), -1), turned_(soup.triangles.size(), 0) {}

    void run(std::int32_t& flipped, std::int32_t& cut) {
        grow_charts();
        for (std::int32_t seed = 0; seed < charts_; ++seed) {
            if (chart_turned_[at(seed)] < 0) orient_component(seed);
        }
        cut += cut_clashes();
        turn_facets();
        turn_closed_outwards();
        flipped += static_cast<std::int32_t>(std::count(turned_.begin(), turned_.end(), 1));
    }

  private:
    /// The same direction in both facets: they are turned against each other.
    bool clash(std::int32_t corner, std::int32_t other) const { return soup_.vertex(corner) == soup_.vertex(other); }

    /// Charts are facets that agree already. One-sided surfaces are cut only between them, where the input itself clashes.
    void grow_charts() {
        std::vector<std::int32_t> facets;
        for (std::int32_t seed = 0; seed < soup_.facet_count(); ++seed) {
            if (chart_[at(seed)] >= 0) continue;
            facets.assign(1, seed);
            chart_[at(seed)] = charts_;
            for (std::size_t i = 0; i < facets.size(); ++i) {
                for (std::int32_t c = 3 * facets[i]; c < 3 * facets[i] + 3; ++c) {
                    const std::int32_t other = mate_[at(c)];
                    if (other < 0 || clash(c, other) || chart_[at(other / 3)] >= 0) continue;
                    chart_[at(other / 3)] = charts_;
                    facets.push_back(other / 3);
                }
            }
            facets_of_chart_.push_back(facets);
            ++charts_;
        }
        chart_turned_.assign(at(charts_), -1);
    }

    /// Breadth-first over the charts of a component; the smaller part of its facets is turned.
    void orient_component(std::int32_t seed) {
        std::vector<std::int32_t> component{seed};
        chart_turned_[at(seed)] = 0;
        std::size_t facets = 0;
        std::size_t turned = 0;
        for (std::size_t i = 0; i < component.size(); ++i) {
            const std::vector<std::int32_t>& own = facets_of_chart_[at(component[i])];
            const std::int8_t side = chart_turned_[at(component[i])];
            facets += own.size();
            turned += side ? own.size() : 0;
            for (const std::int32_t f : own) {
                for (std::int32_t c = 3 * f; c < 3 * f + 3; ++c) {
                    const std::int32_t other = mate_[at(c)];
                    if (other < 0 || chart_turned_[at(chart_[at(other / 3)])] >= 0) continue;
                    chart_turned_[at(chart_[at(other / 3)])] = static_cast<std::int8_t>(1 - side);
                    component.push_back(chart_[at(other / 3)]);
                }
            }
        }
        if (2 * turned <= facets) return;
        for (const std::int32_t chart : component)
            chart_turned_[at(chart)] = static_cast<std::int8_t>(1 - chart_turned_[at(chart)]);
    }

    std::int32_t cut_clashes() {
        std::int32_t cut = 0;
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(mate_.size()); ++c) {
            const std::int32_t other = mate_[at(c)];
            if (other < c) continue;
            const bool turned = chart_turned_[at(chart_[at(c / 3)])] != chart_turned_[at(chart_[at(other / 3)])];
            if (clash(c, other) == turned) continue;
            mate_[at(c)] = mate_[at(other)] = -1;
            ++cut;
        }
        return cut;
    }

    void turn_facets() {
        for (std::int32_t f = 0; f < soup_.facet_count(); ++f) turned_[at(f)] = chart_turned_[at(chart_[at(f)])];
        apply(turned_);
    }

    /// Turns facets: the edges of the first and the third corner change places.
    void apply(const std::vector<char>& turn) {
        const auto moved = [&](std::int32_t c) { return c >= 0 && turn[at(c / 3)] ? 3 * (c / 3) + 2 - c % 3 : c; };
        std::vector<std::int32_t> mate(mate_.size());
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(mate_.size()); ++c) mate[at(moved(c))] = moved(mate_[at(c)]);
        mate_ = std::move(mate);
        for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
            if (turn[f]) std::swap(soup_.triangles[f][1], soup_.triangles[f][2]);
        }
    }

    void turn_closed_outwards() {
        std::vector<char> seen(soup_.triangles.size(), 0);
        std::vector<char> turn(soup_.triangles.size(), 0);
        std::vector<std::int32_t> facets;
        for (std::int32_t seed = 0; seed < soup_.facet_count(); ++seed) {
            if (seen[at(seed)]) continue;
            facets.assign(1, seed);
            seen[at(seed)] = 1;
            bool closed = true;
            double volume = 0.0;
            const Point& from = soup_.point(soup_.triangles[at(seed)][0]);
            for (std::size_t i = 0; i < facets.size(); ++i) {
                const auto& t = soup_.triangles[at(facets[i])];
                volume += (soup_.point(t[0]) - from).cross(soup_.point(t[1]) - from).dot(soup_.point(t[2]) - from);
                for (std::int32_t c = 3 * facets[i]; c < 3 * facets[i] + 3; ++c) {
                    closed = closed && mate_[at(c)] >= 0;
                    if (mate_[at(c)] < 0 || seen[at(mate_[at(c)] / 3)]) continue;
                    seen[at(mate_[at(c)] / 3)] = 1;
                    facets.push_back(mate_[at(c)] / 3);
                }
            }
            if (!closed || !(volume < 0.0)) continue;
            for (const std::int32_t f : facets) {
                turn[at(f)] = 1;
                turned_[at(f)] = static_cast<char>(1 - turned_[at(f)]);
            }
        }
        apply(turn);
    }

    TriangleSoup& soup_;
    std::vector<std::int32_t>& mate_;
    std::vector<std::int32_t> chart_;  ///< per facet
    std::int32_t charts_ = 0;
    std::vector<std::vector<std::int32_t>> facets_of_chart_;
    std::vector<std::int8_t> chart_turned_;  ///< -1 = not known yet
    std::vector<char> turned_;               ///< per facet, against the input
};

}  // namespace

void unify_orientation(TriangleSoup& soup, std::vector<std::int32_t>& mate, std::int32_t& flipped, std::int32_t& cut) {
    Orientation(soup, mate).run(flipped, cut);
}

}  // namespace anisoquad
