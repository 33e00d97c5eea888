#pragma once

#include <cmath>
#include <random>

#include "picking/pick_surface.h"
#include "shapes.h"

namespace anisoquad::shapes {

inline PickSurface pick_surface(const Shape& shape, double feature_angle = 40.0,
                                const std::vector<std::array<std::int32_t, 2>>& feature_edges = {}) {
    return make_pick_surface(shape.points, shape.triangles, feature_angle, feature_edges);
}

/// A grid of n × n cells whose inner points are moved at random and whose diagonals are then chosen by Delaunay's rule: paths
/// over it zigzag.
inline Shape unstructured(int n) {
    Shape shape = grid(n, n);
    std::mt19937 random(7);  // the same numbers on every machine, unlike the distributions
    const auto shift = [&random] { return 0.6 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
    for (Point& p : shape.points) {
        if (p.x() > 0.0 && p.x() < n) p.x() += p.y() > 0.0 && p.y() < n ? shift() : 0.0;
        if (p.y() > 0.0 && p.y() < n && p.x() > 0.0 && p.x() < n) p.y() += shift();
    }
    for (std::size_t cell = 0; cell + 1 < shape.triangles.size(); cell += 2) {
        auto& first = shape.triangles[cell];
        auto& second = shape.triangles[cell + 1];
        const std::array<std::int32_t, 4> q = first[2] == second[1] ? std::array{first[0], first[1], first[2], second[2]}
                                                                    : std::array{first[0], first[1], second[1], first[2]};
        const auto length = [&](std::size_t a, std::size_t b) {
            return (shape.points[static_cast<std::size_t>(q[a])] - shape.points[static_cast<std::size_t>(q[b])]).norm();
        };
        if (length(0, 2) <= length(1, 3)) {
            first = {q[0], q[1], q[2]};
            second = {q[0], q[2], q[3]};
        } else {
            first = {q[0], q[1], q[3]};
            second = {q[1], q[2], q[3]};
        }
    }
    return shape;
}

/// A smooth ridge along x at y = 0: z = height / (1 + (y / width)²).
inline Shape ridge(int nx, int ny, double height, double width) {
    Shape shape = grid(nx, 2 * ny);
    for (Point& p : shape.points) {
        const double y = p.y() - ny;
        p = {p.x(), y, height / (1.0 + y * y / (width * width))};
    }
    return shape;
}

inline std::vector<Vertex> vertices(const std::vector<std::int32_t>& path) {
    std::vector<Vertex> result;
    for (const std::int32_t v : path) result.emplace_back(v);
    return result;
}

inline double length(const std::vector<Point>& points, const std::vector<std::int32_t>& path) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        sum += (points[static_cast<std::size_t>(path[i + 1])] - points[static_cast<std::size_t>(path[i])]).norm();
    return sum;
}

}  // namespace anisoquad::shapes
