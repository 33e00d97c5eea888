#include "cad/edge_chain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "cad/to_eigen.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

/// Unit direction at one end of an edge, leaving it.
Vector3d outward(const CadEdge& edge, std::size_t end) {
    gp_Pnt p;
    gp_Vec d;
    edge.curve->D1(end == 0 ? edge.range.low : edge.range.high, p, d);
    const Vector3d along = to_eigen(d);
    if (!(along.norm() > 0.0)) return Vector3d::Zero();
    return end == 0 ? Vector3d(-along.normalized()) : Vector3d(along.normalized());
}

class Chain {
  public:
    Chain(const CadShape& shape, std::int32_t edge, double angle)
        : shape_(shape),
          cosine_(std::cos(angle * std::numbers::pi / 180.0)),
          used_(shape.edges().size(), 0),
          chain_{{edge, false}} {
        used_[static_cast<std::size_t>(edge)] = 1;
    }

    std::vector<DirectedEdge> run() {
        if (shape_.edge(chain_.front().edge).range.closed) return {chain_.begin(), chain_.end()};
        while (grow(chain_.back(), true)) {
        }
        while (grow(chain_.front(), false)) {
        }
        return {chain_.begin(), chain_.end()};
    }

  private:
    /// Adds what goes on from the chain's last edge, or before its first one.
    bool grow(DirectedEdge from, bool ahead) {
        const CadEdge& edge = shape_.edge(from.edge);
        const std::size_t end = ahead != from.reversed ? 1 : 0;
        const Vector3d direction = outward(edge, end);
        double best = cosine_;
        DirectedEdge found;
        for (std::size_t i = 0; i < shape_.edges().size(); ++i) {
            const CadEdge& other = shape_.edges()[i];
            if (used_[i] || other.is_degenerated() || other.range.closed) continue;
            for (std::size_t k = 0; k < 2; ++k) {
                if (other.vertex[k] != edge.vertex[end]) continue;
                const double straight = -outward(other, k).dot(direction);
                if (straight < best) continue;
                best = straight;
                found = {static_cast<std::int32_t>(i), (k == 1) == ahead};
            }
        }
        if (found.edge < 0) return false;
        used_[static_cast<std::size_t>(found.edge)] = 1;
        if (ahead) {
            chain_.push_back(found);
        } else {
            chain_.push_front(found);
        }
        return true;
    }

    const CadShape& shape_;
    double cosine_;
    std::vector<char> used_;
    std::deque<DirectedEdge> chain_;
};

}  // namespace

std::vector<DirectedEdge> tangent_chain(const CadShape& shape, std::int32_t edge, double angle) {
    if (edge < 0 || edge >= static_cast<std::int32_t>(shape.edges().size())) {
        throw Error(ErrorCode::invalid_source, shape.name() + " has no Edge" + std::to_string(edge + 1) + ".");
    }
    if (shape.edge(edge).is_degenerated()) return {{edge, false}};
    return Chain(shape, edge, angle).run();
}

std::vector<std::int32_t> path_on_edges(const CadShape& shape, std::span<const EdgePath> paths,
                                        std::span<const std::int32_t> edges, bool reversed) {
    const auto fail = [&](const std::string& why, std::vector<std::int32_t> ids) {
        throw Error(ErrorCode::invalid_source, why, ElementKind::cad_edge, std::move(ids));
    };
    std::vector<std::int32_t> left;
    for (const std::int32_t e : edges) {
        if (e < 0 || e >= static_cast<std::int32_t>(paths.size()))
            fail(shape.name() + " has no Edge" + std::to_string(e + 1) + ".", {});
        if (paths[static_cast<std::size_t>(e)].vertices.empty()) {
            fail("No mesh edges lie on " + CadShape::names("Edge", std::span(&e, 1)) + " of " + shape.name() + ".", {e});
        }
        if (paths[static_cast<std::size_t>(e)].vertices.size() > 1 && std::find(left.begin(), left.end(), e) == left.end())
            left.push_back(e);
    }
    if (left.empty()) fail("No edges are chosen that the mesh could follow.", {edges.begin(), edges.end()});
    std::deque<std::int32_t> path;
    for (bool first = true; !left.empty(); first = false) {
        bool joined = false;
        for (auto e = left.begin(); e != left.end() && !joined; ++e) {
            std::vector<std::int32_t> v = paths[static_cast<std::size_t>(*e)].vertices;
            if (first) {
                path.assign(v.begin(), v.end());
            } else if (path.front() == path.back()) {
                break;
            } else if (v.front() == path.back() || v.back() == path.back()) {
                if (v.front() != path.back()) std::reverse(v.begin(), v.end());
                path.insert(path.end(), v.begin() + 1, v.end());
            } else if (v.front() == path.front() || v.back() == path.front()) {
                if (v.back() != path.front()) std::reverse(v.begin(), v.end());
                path.insert(path.begin(), v.begin(), v.end() - 1);
            } else {
                continue;
            }
            left.erase(e);
            joined = true;
            break;
        }
        if (!joined)
            fail(CadShape::names("Edge", edges) + " of " + shape.name() + " are not one line.", {edges.begin(), edges.end()});
    }
    if (reversed) return {path.rbegin(), path.rend()};
    return {path.begin(), path.end()};
}

}  // namespace anisoquad::cad
