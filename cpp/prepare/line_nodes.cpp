#include "prepare/line_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/euler_operators.h"
#include "prepare/collapse_check.h"
#include "prepare/triangle_shape.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kLong = 4.0 / 3.0;
constexpr double kShort = 0.7;
constexpr double kLeastMove = 1e-3;   ///< of the edges' lengths
constexpr double kLeastShape = 0.05;  ///< of a triangle beside a node that slides

class Redistribution {
  public:
    Redistribution(SurfaceMesh& mesh, LineNodes& line, const ReferenceLines& lines, const ReferenceSurface& surface,
                   const LineOptions& options)
        : mesh_(mesh), line_(line), reference_(lines), surface_(surface), options_(options) {}

    std::int32_t run() {
        collapse_short();
        split_long();
        slide();
        return changes_;
    }

  private:
    double wanted(Vertex a, Vertex b) const { return 0.5 * (mesh_.info(a).size + mesh_.info(b).size); }
    double length(Vertex a, Vertex b) const { return (mesh_.position(a) - mesh_.position(b)).norm(); }

    void collapse_short() {
        std::vector<Vertex> nodes{line_.nodes[0]};
        std::vector<double> ways{line_.ways[0]};
        const std::size_t n = line_.nodes.size();
        const std::size_t least = line_.nodes.front() == line_.nodes.back() ? 4 : 2;
        std::size_t left = n;
        for (std::size_t i = 1; i < n; ++i) {
            const Vertex v = line_.nodes[i];
            if (i + 1 < n && left > least && is_superfluous(nodes.back(), ways.back(), i)) {
                const HalfEdge back = mesh_.find_halfedge(v, nodes.back());
                const HalfEdge ahead = mesh_.find_halfedge(v, line_.nodes[i + 1]);
                const HalfEdge first = mesh_.length(back) < mesh_.length(ahead) ? back : ahead;
                for (const HalfEdge h : {first, first == back ? ahead : back}) {
                    if (try_collapse(mesh_, h, surface_, options_.sagitta, options_.coverage)) break;
                }
                if (mesh_.is_deleted(v)) {
                    ++changes_;
                    --left;
                    continue;
                }
            }
            nodes.push_back(v);
            ways.push_back(line_.ways[i]);
        }
        line_.nodes = std::move(nodes);
        line_.ways = std::move(ways);
    }

    /// Between the last kept node and the one after it, node i is too close to one of them, and not needed for the shape.
    bool is_superfluous(Vertex last, double way, std::size_t i) const {
        const Vertex v = line_.nodes[i];
        const Vertex next = line_.nodes[i + 1];
        if (mesh_.info(v).kind != NodeKind::line || last == next) return false;
        const double back = length(last, v) / wanted(last, v);
        const double ahead = length(v, next) / wanted(v, next);
        if (std::min(back, ahead) > kShort || length(last, next) > kLong * wanted(last, next)) return false;
        return reference_.deviation(line_.line, way, line_.ways[i + 1]) <= options_.deviation;
    }

    void split_long() {
        std::vector<Vertex> nodes{line_.nodes[0]};
        std::vector<double> ways{line_.ways[0]};
        for (std::size_t i = 1; i < line_.nodes.size(); ++i) {
            const Vertex a = nodes.back();
            const Vertex b = line_.nodes[i];
            const double share = length(a, b) / wanted(a, b);
            if (share > kLong || reference_.deviation(line_.line, ways.back(), line_.ways[i]) > options_.deviation) {
                const double parts = options_.equal_parts ? std::max(2.0, std::round(share)) : 2.0;
                const double t = std::floor(0.5 * parts) / parts;
                const double middle = (1.0 - t) * ways.back() + t * line_.ways[i];
                const Point between = (1.0 - t) * mesh_.position(a) + t * mesh_.position(b);
                const Vertex v = split_covered_edge(mesh_, M::edge(mesh_.find_halfedge(a, b)), between, options_.coverage);
                mesh_.info(v).line = line_.line;
                // Off the straight edge only where no triangle beside it is turned over.
                place(v, reference_.at(line_.line, middle));
                nodes.push_back(v);
                ways.push_back(middle);
                ++changes_;
            }
            nodes.push_back(b);
            ways.push_back(line_.ways[i]);
        }
        line_.nodes = std::move(nodes);
        line_.ways = std::move(ways);
    }

    void slide() {
        for (std::size_t i = 1; i + 1 < line_.nodes.size(); ++i) {
            const Vertex v = line_.nodes[i];
            if (mesh_.info(v).kind != NodeKind::line) continue;
            const double before = wanted(line_.nodes[i - 1], v);
            const double after = wanted(v, line_.nodes[i + 1]);
            const double from = line_.ways[i - 1];
            const double to = line_.ways[i + 1];
            double target = from + (to - from) * before / (before + after);
            if (std::abs(target - line_.ways[i]) < kLeastMove * (to - from)) continue;
            for (int tries = 0; tries < 3; ++tries, target = 0.5 * (target + line_.ways[i])) {
                if (reference_.deviation(line_.line, from, target) > options_.deviation ||
                    reference_.deviation(line_.line, target, to) > options_.deviation ||
                    !place(v, reference_.at(line_.line, target))) {
                    continue;
                }
                line_.ways[i] = target;
                break;
            }
        }
    }

    /// Moves a node of the line, unless a triangle round it would be turned over against its patch or become a sliver.
    bool place(Vertex v, const Point& p) {
        const Point kept = mesh_.position(v);
        if (p == kept) return true;
        for (const HalfEdge out : mesh_.outgoing(v)) {
            if (mesh_.is_boundary(out)) continue;
            const Point& a = mesh_.position(mesh_.to(out));
            const Point& b = mesh_.position(mesh_.to(mesh_.next(out)));
            const Vector3d before = (a - kept).cross(b - kept);
            const Vector3d after = (a - p).cross(b - p);
            if (!(after.dot(before) > 0.0) || triangle_shape(p, a, b) < std::min(kLeastShape, triangle_shape(kept, a, b)))
                return false;
        }
        const std::int32_t input = mesh_.info(v).input;
        if (options_.coverage) options_.coverage->lift(mesh_, v);
        mesh_.position(v) = p;
        mesh_.info(v).input = -1;
        const bool covered = !options_.coverage || options_.coverage->is_covered_round(mesh_, v);
        if (!covered) {
            mesh_.position(v) = kept;
            mesh_.info(v).input = input;
        }
        if (options_.coverage) options_.coverage->drop(mesh_, v);
        return covered;
    }

    SurfaceMesh& mesh_;
    LineNodes& line_;
    const ReferenceLines& reference_;
    const ReferenceSurface& surface_;
    const LineOptions& options_;
    std::int32_t changes_ = 0;
};

}  // namespace

std::vector<LineNodes> line_nodes(const SurfaceMesh& mesh, std::span<const FeatureLine> lines, const ReferenceLines& reference) {
    std::vector<LineNodes> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        LineNodes& line = result.emplace_back();
        line.line = static_cast<std::int32_t>(i);
        line.nodes = lines[i].nodes;
        line.ways.push_back(0.0);
        for (std::size_t k = 1; k < line.nodes.size(); ++k) {
            line.ways.push_back(line.ways.back() + (mesh.position(line.nodes[k]) - mesh.position(line.nodes[k - 1])).norm());
        }
        line.ways.back() = reference.length(line.line);
    }
    return result;
}

std::int32_t redistribute_line_nodes(SurfaceMesh& mesh, LineNodes& line, const ReferenceLines& lines,
                                     const ReferenceSurface& surface, const LineOptions& options) {
    return Redistribution(mesh, line, lines, surface, options).run();
}

}  // namespace anisoquad
