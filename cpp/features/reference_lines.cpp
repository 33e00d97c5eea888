#include "features/reference_lines.h"

#include <algorithm>
#include <cmath>

namespace anisoquad {

ReferenceLines::ReferenceLines(const SurfaceMesh& mesh, std::span<const FeatureLine> lines) {
    for (const FeatureLine& line : lines) {
        Line kept;
        kept.closed = line.closed;
        for (const Vertex v : line.nodes) {
            const Point& p = mesh.position(v);
            kept.way.push_back(kept.points.empty() ? 0.0 : kept.way.back() + (p - kept.points.back()).norm());
            kept.points.push_back(p);
            kept.vertices.push_back(v.index());
        }
        lines_.push_back(std::move(kept));
    }
}

Point ReferenceLines::at(std::int32_t line, double way) const {
    const Line& l = lines_[static_cast<std::size_t>(line)];
    if (l.closed) way -= std::floor(way / l.way.back()) * l.way.back();
    const auto after = std::upper_bound(l.way.begin(), l.way.end(), way);
    if (after == l.way.begin()) return l.points.front();
    if (after == l.way.end()) return l.points.back();
    const auto i = static_cast<std::size_t>(after - l.way.begin());
    const double t = (way - l.way[i - 1]) / (l.way[i] - l.way[i - 1]);
    return l.points[i - 1] + t * (l.points[i] - l.points[i - 1]);
}

double ReferenceLines::closest(std::int32_t line, const Point& p) const {
    const Line& l = lines_[static_cast<std::size_t>(line)];
    double best = 1e300;
    double way = 0.0;
    for (std::size_t i = 1; i < l.points.size(); ++i) {
        const Eigen::Vector3d along = l.points[i] - l.points[i - 1];
        const double t = std::clamp((p - l.points[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double distance = (l.points[i - 1] + t * along - p).squaredNorm();
        if (distance < best) {
            best = distance;
            way = l.way[i - 1] + t * (l.way[i] - l.way[i - 1]);
        }
    }
    return way;
}

ReferenceLines::EdgePlace ReferenceLines::edge_at(std::int32_t line, double way) const {
    const Line& l = lines_[static_cast<std::size_t>(line)];
    if (l.closed) way -= std::floor(way / l.way.back()) * l.way.back();
    const auto after = std::upper_bound(l.way.begin() + 1, l.way.end() - 1, way);
    const auto i = static_cast<std::size_t>(after - l.way.begin());
    return {{l.vertices[i - 1], l.vertices[i]}, std::clamp((way - l.way[i - 1]) / (l.way[i] - l.way[i - 1]), 0.0, 1.0)};
}

double ReferenceLines::deviation(std::int32_t line, double from, double to) const {
    const Line& l = lines_[static_cast<std::size_t>(line)];
    const Point a = at(line, from);
    const Eigen::Vector3d along = at(line, to) - a;
    const double squared = along.squaredNorm();
    double largest = 0.0;
    const auto add = [&](const Point& p) {
        const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
        largest = std::max(largest, (a + t * along - p).norm());
    };
    // A closed line is run through twice, since `to` may lie past its first node.
    for (const double shift : {0.0, l.closed ? l.way.back() : -1.0}) {
        if (shift < 0.0) break;
        const auto first = std::upper_bound(l.way.begin(), l.way.end(), from - shift);
        for (auto i = first; i != l.way.end() && *i + shift < to; ++i) add(l.points[static_cast<std::size_t>(i - l.way.begin())]);
    }
    return largest;
}

}  // namespace anisoquad
