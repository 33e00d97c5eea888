#include "cad/edge_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cad/closest_point.h"
#include "cad/corners.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

constexpr double kExact = 1e-9;  ///< of the diagonal: of vertices of double precision
constexpr double kBow = 0.6;     ///< largest distance of the curve from a mesh edge's middle, over the edge's length

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Tracer {
  public:
    Tracer(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles, double tolerance)
        : shape_(shape),
          points_(points),
          neighbours_(points.size(), triangles),
          tolerance_(tolerance),
          least_(kRounding * shape.diagonal()) {}

    EdgePaths run(std::span<const EdgePath> known) {
        result_.paths.resize(shape_.edges().size());
        result_.at_vertex = find_corners(shape_, points_, neighbours_);
        for (std::size_t e = 0; e < known.size(); ++e) {
            if (shape_.edges()[e].is_degenerated() || !along_edges(known[e].vertices)) continue;
            result_.paths[e] = known[e];
            result_.at_vertex[at(shape_.edges()[e].vertex[0])] = known[e].vertices.front();
            result_.at_vertex[at(shape_.edges()[e].vertex[1])] = known[e].vertices.back();
        }
        for (std::size_t e = 0; e < shape_.edges().size(); ++e) {
            const CadEdge& edge = shape_.edges()[e];
            if (result_.paths[e].vertices.empty() && !edge.is_degenerated()) result_.paths[e] = find(edge);
        }
        return std::move(result_);
    }

  private:
    bool along_edges(const std::vector<std::int32_t>& path) const {
        for (std::size_t i = 1; i < path.size(); ++i) {
            const auto next = neighbours_.of(path[i - 1]);
            if (!std::binary_search(next.begin(), next.end(), path[i])) return false;
        }
        return !path.empty();
    }

    /// Where that leads nowhere, since vertices beside a sharp nose are almost on the edge, only along those that are on it.
    EdgePath find(const CadEdge& edge) const {
        const EdgePath path = trace(edge, least_);
        return path.vertices.empty() ? trace(edge, kExact * shape_.diagonal()) : path;
    }

    /// @param least distance of a vertex from the curve that passes in any case
    EdgePath trace(const CadEdge& edge, double least) const {
        const std::int32_t first = result_.at_vertex[at(edge.vertex[0])];
        const std::int32_t last = result_.at_vertex[at(edge.vertex[1])];
        if (first < 0 || last < 0) return {};
        EdgePath path{{first}, {edge.range.low}};
        if (first == last && !edge.range.closed) return edge.length <= 2.0 * least_ ? path : EdgePath{};
        // Every step goes on along the curve, and to a vertex that was not passed before.
        while (path.vertices.size() <= points_.size()) {
            const Step step = next(edge, path, last, least);
            if (step.vertex < 0) return {};
            path.vertices.push_back(step.vertex);
            path.parameters.push_back(step.parameter);
            if (step.vertex == last) return path;
        }
        return {};
    }

    struct Step {
        std::int32_t vertex = -1;
        double parameter = 0.0;
    };

    /// The neighbour that comes first along the curve. Vertices of a tessellation are on the curve to within rounding; only where
    /// none is, those near it count, since a vertex beside the edge of a thin face is near it too.
    Step next(const CadEdge& edge, const EdgePath& path, std::int32_t last, double least) const {
        const std::int32_t v = path.vertices.back();
        const double t = path.parameters.back();
        struct Try {
            bool anywhere;
            double tolerance;
        };
        for (const auto [anywhere, tolerance] :
             {Try{false, 0.0}, Try{true, 0.0}, Try{false, tolerance_}, Try{true, tolerance_}}) {
            Step best;
            for (const std::int32_t w : neighbours_.of(v)) {
                const double way = (points_[at(w)] - points_[at(v)]).norm();
                const double reach = std::max(least, tolerance * way);
                double place = edge.range.high;
                if (w != last) {
                    const EdgePoint on = anywhere
                                             ? closest_on_edge(edge, points_[at(w)])
                                             : closest_on_edge(edge, points_[at(w)], t + way / std::max(speed(edge, t), 1e-300));
                    if (on.distance > reach || !(on.parameter > t)) continue;
                    place = on.parameter;
                }
                if ((best.vertex >= 0 && !(place < best.parameter)) || !follows(edge, v, w, 0.5 * (t + place), way)) continue;
                best = {w, place};
            }
            if (best.vertex >= 0) return best;
        }
        return {};
    }

    static double speed(const CadEdge& edge, double t) {
        gp_Pnt p;
        gp_Vec d;
        edge.curve->D1(t, p, d);
        return d.Magnitude();
    }

    /// The curve between two places stays near the mesh edge between them.
    bool follows(const CadEdge& edge, std::int32_t v, std::int32_t w, double middle, double way) const {
        const gp_Pnt p = edge.curve->Value(middle);
        return (Vector3d(p.X(), p.Y(), p.Z()) - 0.5 * (points_[at(v)] + points_[at(w)])).norm() <= std::max(least_, kBow * way);
    }

    const CadShape& shape_;
    std::span<const Vector3d> points_;
    Neighbours neighbours_;
    double tolerance_;
    double least_;
    EdgePaths result_;
};

}  // namespace

Neighbours::Neighbours(std::size_t vertices, Triangles triangles) : first_(vertices + 1, 0) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    pairs.reserve(6 * triangles.size());
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            pairs.push_back({t[k], t[(k + 1) % 3]});
            pairs.push_back({t[(k + 1) % 3], t[k]});
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [from, to] : pairs) {
        ++first_[at(from) + 1];
        list_.push_back(to);
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

EdgePaths find_edge_paths(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles, double tolerance,
                          std::span<const EdgePath> known) {
    return Tracer(shape, points, triangles, tolerance).run(known);
}

}  // namespace anisoquad::cad
