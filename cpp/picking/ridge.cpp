#include "picking/ridge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "errors.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr double kLargestTurn = 0.64;  ///< cosine is 0.8: of two edges of a ridge that follow each other
constexpr double kFading = 0.35;       ///< a ridge ends where its curvature falls below this part of the strongest so far
constexpr double kRidge = 6.0;         ///< times the surface's mean curvature: what begins a ridge
constexpr double kShortest = 0.25;     ///< of the diagonal: what is worth a suggestion
constexpr double kApart = 0.04;        ///< of the diagonal: nearer lines are the same

double curvature(const PickSurface& surface, HalfEdge h) {
    return surface.curvature[static_cast<std::size_t>(M::edge(h).index())];
}

double length(const PickSurface& surface, const std::vector<std::int32_t>& path) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        sum += (surface.points[static_cast<std::size_t>(path[i + 1])] - surface.points[static_cast<std::size_t>(path[i])]).norm();
    return sum;
}

/// The edge on which the ridge that comes along `h` goes on; invalid at its end.
HalfEdge next_on_ridge(const PickSurface& surface, HalfEdge h, double least) {
    const SurfaceMesh& mesh = surface.mesh;
    const Eigen::Vector3d along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
    HalfEdge best;
    double best_score = 0.0;
    for (const HalfEdge out : mesh.outgoing(mesh.to(h))) {
        const double cosine = (mesh.position(mesh.to(out)) - mesh.position(mesh.from(out))).normalized().dot(along);
        const double k = curvature(surface, out);
        if (cosine < std::cos(kLargestTurn) || k < least) continue;
        const double score = k * cosine * cosine * cosine * cosine;
        if (score > best_score) {
            best_score = score;
            best = out;
        }
    }
    return best;
}

/// Vertices after to(h), up to the ridge's end or back to `first`.
std::vector<std::int32_t> follow(const PickSurface& surface, HalfEdge h, std::vector<bool>& visited, std::int32_t first) {
    std::vector<std::int32_t> path;
    double strongest = curvature(surface, h);
    for (;;) {
        h = next_on_ridge(surface, h, kFading * strongest);
        if (!h.is_valid()) return path;
        strongest = std::max(strongest, curvature(surface, h));
        const std::int32_t v = surface.mesh.to(h).index();
        if (v == first) path.push_back(v);
        if (visited[static_cast<std::size_t>(v)]) return path;
        visited[static_cast<std::size_t>(v)] = true;
        path.push_back(v);
    }
}

std::vector<std::int32_t> ridge_through(const PickSurface& surface, HalfEdge h) {
    std::vector<bool> visited(surface.points.size(), false);
    const std::int32_t from = surface.mesh.from(h).index();
    const std::int32_t to = surface.mesh.to(h).index();
    visited[static_cast<std::size_t>(from)] = visited[static_cast<std::size_t>(to)] = true;
    std::vector<std::int32_t> path{from, to};
    const std::vector<std::int32_t> ahead = follow(surface, h, visited, from);
    path.insert(path.end(), ahead.begin(), ahead.end());
    if (path.back() == from) return path;
    std::vector<std::int32_t> behind = follow(surface, M::twin(h), visited, -1);
    std::reverse(behind.begin(), behind.end());
    path.insert(path.begin(), behind.begin(), behind.end());
    return path;
}

std::vector<std::int32_t> nodes_of(const FeatureLine& line) {
    std::vector<std::int32_t> path;
    for (const Vertex v : line.nodes) path.push_back(v.index());
    return path;
}

/// Marks everything within a way of the path over the edges.
void mark_near(const PickSurface& surface, const std::vector<std::int32_t>& path, double reach, std::vector<bool>& near) {
    std::vector<double> way(surface.points.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto reach_vertex = [&](std::int32_t v, double distance) {
        if (distance > reach || distance >= way[static_cast<std::size_t>(v)]) return;
        way[static_cast<std::size_t>(v)] = distance;
        near[static_cast<std::size_t>(v)] = true;
        queue.emplace(distance, v);
    };
    for (const std::int32_t v : path) reach_vertex(v, 0.0);
    while (!queue.empty()) {
        const auto [distance, v] = queue.top();
        queue.pop();
        if (distance > way[static_cast<std::size_t>(v)]) continue;
        for (const HalfEdge h : surface.mesh.outgoing(Vertex(v)))
            reach_vertex(surface.mesh.to(h).index(), distance + surface.mesh.length(h));
    }
}

bool is_convex(const PickSurface& surface, const FeatureLine& line) {
    double turn = 0.0;
    for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i) {
        const HalfEdge h = surface.mesh.find_halfedge(line.nodes[i], line.nodes[i + 1]);
        turn += curvature(surface, h) * surface.mesh.length(h);
    }
    return turn > 0.0;
}

}  // namespace

std::vector<std::int32_t> whole_line(const PickSurface& surface, std::int32_t from, std::int32_t to) {
    const auto count = surface.mesh.vertex_slots();
    const bool known = from >= 0 && to >= 0 && from < count && to < count;
    const HalfEdge h = known ? surface.mesh.find_halfedge(Vertex(from), Vertex(to)) : HalfEdge();
    if (!h.is_valid()) throw Error(ErrorCode::invalid_source, "No mesh edge joins these points.", ElementKind::edge, {from, to});
    const std::int32_t line = surface.mesh.info(M::edge(h)).line;
    if (line >= 0) return nodes_of(surface.lines[static_cast<std::size_t>(line)]);
    if (curvature(surface, h) < surface.mean_curvature) return {from, to};
    return ridge_through(surface, h);
}

std::vector<std::vector<std::int32_t>> suggest_lines(const PickSurface& surface) {
    const double shortest = kShortest * surface.diagonal;
    std::vector<std::vector<std::int32_t>> found;
    std::vector<bool> near(surface.points.size(), false);
    const auto take = [&](std::vector<std::int32_t> path) {
        mark_near(surface, path, kApart * surface.diagonal, near);
        if (length(surface, path) >= shortest) found.push_back(std::move(path));
    };
    for (const FeatureLine& line : surface.lines) {
        if (!line.is_boundary && is_convex(surface, line)) take(nodes_of(line));
    }
    std::vector<std::int32_t> order(surface.curvature.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return surface.curvature[static_cast<std::size_t>(a)] > surface.curvature[static_cast<std::size_t>(b)];
    });
    for (const std::int32_t e : order) {
        if (surface.curvature[static_cast<std::size_t>(e)] < kRidge * surface.mean_curvature) break;
        const HalfEdge h = M::halfedge(Edge(e));
        const auto is_near = [&](Vertex v) { return near[static_cast<std::size_t>(v.index())]; };
        if (is_near(surface.mesh.from(h)) || is_near(surface.mesh.to(h))) continue;
        take(ridge_through(surface, h));
    }
    std::stable_sort(found.begin(), found.end(),
                     [&](const auto& a, const auto& b) { return length(surface, a) > length(surface, b); });
    return found;
}

}  // namespace anisoquad
