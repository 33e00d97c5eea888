#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "features/feature_lines.h"

namespace anisoquad {

/// The feature lines as the input has them, kept unchanged: what their nodes slide along. A place on a line is the way along
/// it from its first node.
class ReferenceLines {
  public:
    ReferenceLines() = default;
    /// @param mesh with its nodes still at their input places
    ReferenceLines(const SurfaceMesh& mesh, std::span<const FeatureLine> lines);

    bool empty() const { return lines_.empty(); }
    bool is_closed(std::int32_t line) const { return lines_[static_cast<std::size_t>(line)].closed; }
    double length(std::int32_t line) const { return lines_[static_cast<std::size_t>(line)].way.back(); }
    /// Point at a place, taken round on a closed line, held at the ends of an open one.
    Point at(std::int32_t line, double way) const;
    /// Place closest to p.
    double closest(std::int32_t line, const Point& p) const;
    /// The input edge that holds the place closest to p: its vertices, and how far from the first to the second, 0…1.
    struct EdgePlace {
        std::array<std::int32_t, 2> edge{-1, -1};
        double share = 0.0;
    };
    EdgePlace closest_edge(std::int32_t line, const Point& p) const { return edge_at(line, closest(line, p)); }
    /// The same for a place, as in at().
    EdgePlace edge_at(std::int32_t line, double way) const;
    /// Largest distance of the line between two places, from < to ≤ from + length, from the straight edge between them.
    double deviation(std::int32_t line, double from, double to) const;

  private:
    struct Line {
        std::vector<Point> points;
        std::vector<double> way;
        std::vector<std::int32_t> vertices;
        bool closed = false;
    };
    std::vector<Line> lines_;
};

}  // namespace anisoquad
