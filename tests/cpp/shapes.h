#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "mesh/arrays.h"

/// Surfaces for tests, as points and consistently oriented triangles (normals outwards or up).
namespace anisoquad::shapes {

struct Shape {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;

    SurfaceMesh mesh() const { return from_arrays(points, triangles); }

    /// Two triangles of the quad a, b, c, d; `flipped` takes the other diagonal.
    void add_quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, bool flipped = false) {
        triangles.push_back({a, b, flipped ? d : c});
        triangles.push_back({flipped ? b : a, c, d});
    }
};

/// nx × ny cells of the given size in the plane z = 0; the point (i, j) has the index j·(nx + 1) + i.
/// @param keep says which cells (i, j) exist: cells left out make holes; their points stay as isolated ones
template <class Keep>
Shape grid_with_holes(int nx, int ny, Keep keep, double dx = 1.0, double dy = 1.0) {
    Shape shape;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) shape.points.emplace_back(i * dx, j * dy, 0.0);
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const std::int32_t a = j * (nx + 1) + i;
            if (keep(i, j)) shape.add_quad(a, a + 1, a + nx + 2, a + nx + 1, (i + j) % 2 == 1);
        }
    }
    return shape;
}

inline Shape grid(int nx, int ny, double dx = 1.0, double dy = 1.0) {
    return grid_with_holes(
        nx, ny, [](int, int) { return true; }, dx, dy);
}

/// n × m cells bent to a band of the given radius around z, open at both ends; point (i, j) has the index j·n + i.
inline Shape cylinder(int n, int m, double radius = 1.0, double height = 2.0) {
    Shape shape;
    for (int j = 0; j <= m; ++j) {
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n;
            shape.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * j / m);
        }
    }
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < n; ++i) {
            const std::int32_t right = (i + 1) % n;
            shape.add_quad(j * n + i, j * n + right, (j + 1) * n + right, (j + 1) * n + i, (i + j) % 2 == 1);
        }
    }
    return shape;
}

/// n meridians around z and m rings from pole to pole.
inline Shape sphere(int n, int m, double radius = 1.0) {
    Shape shape;
    for (int j = 1; j < m; ++j) {
        const double polar = std::numbers::pi * j / m;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n;
            shape.points.emplace_back(radius * std::sin(polar) * std::cos(angle), radius * std::sin(polar) * std::sin(angle),
                                      radius * std::cos(polar));
        }
    }
    const std::int32_t top = n * (m - 1);
    shape.points.emplace_back(0.0, 0.0, radius);
    shape.points.emplace_back(0.0, 0.0, -radius);
    for (int i = 0; i < n; ++i) {
        const std::int32_t right = (i + 1) % n;
        shape.triangles.push_back({top, i, right});
        for (int j = 0; j + 2 < m; ++j)
            shape.add_quad(j * n + i, (j + 1) * n + i, (j + 1) * n + right, j * n + right, (i + j) % 2 == 1);
        shape.triangles.push_back({top + 1, (m - 2) * n + right, (m - 2) * n + i});
    }
    return shape;
}

/// A cone of radius 1 round z, open below: n meridians and m rings; the last point is its top at (0, 0, height).
inline Shape cone(int n, int m, double height) {
    Shape shape;
    for (int j = 0; j < m; ++j) {
        const double radius = 1.0 - static_cast<double>(j) / m;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n;
            shape.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * (1.0 - radius));
        }
    }
    shape.points.emplace_back(0.0, 0.0, height);
    for (int i = 0; i < n; ++i) {
        const std::int32_t right = (i + 1) % n;
        for (int j = 0; j + 1 < m; ++j)
            shape.add_quad(j * n + i, j * n + right, (j + 1) * n + right, (j + 1) * n + i, (i + j) % 2 == 1);
        shape.triangles.push_back({(m - 1) * n + i, (m - 1) * n + right, n * m});
    }
    return shape;
}

inline Shape torus(int n, int m, double major = 2.0, double minor = 0.7) {
    Shape shape;
    for (int j = 0; j < m; ++j) {
        const double v = 2.0 * std::numbers::pi * j / m;
        for (int i = 0; i < n; ++i) {
            const double u = 2.0 * std::numbers::pi * i / n;
            const double r = major + minor * std::cos(v);
            shape.points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
        }
    }
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < n; ++i) {
            const std::int32_t right = (i + 1) % n;
            const std::int32_t up = (j + 1) % m;
            shape.add_quad(j * n + i, j * n + right, up * n + right, up * n + i, (i + j) % 2 == 1);
        }
    }
    return shape;
}

/// Surface of the box [0, n]³ with n × n cells a side.
inline Shape cube(int n) {
    Shape shape;
    std::vector<std::int32_t> index(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
    const auto node = [&](const std::array<int, 3>& p) {
        std::int32_t& i = index[static_cast<std::size_t>((p[2] * (n + 1) + p[1]) * (n + 1) + p[0])];
        if (i < 0) {
            i = static_cast<std::int32_t>(shape.points.size());
            shape.points.emplace_back(p[0], p[1], p[2]);
        }
        return i;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            const std::size_t u = (axis + (high ? 1 : 2)) % 3;  // u × v points outwards
            const std::size_t v = (axis + (high ? 2 : 1)) % 3;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    std::array<int, 3> p{};
                    p[axis] = high ? n : 0;
                    const auto corner = [&](int di, int dj) {
                        p[u] = i + di;
                        p[v] = j + dj;
                        return node(p);
                    };
                    const std::int32_t a = corner(0, 0);
                    const std::int32_t b = corner(1, 0);
                    const std::int32_t c = corner(1, 1);
                    shape.add_quad(a, b, c, corner(0, 1), (i + j) % 2 == 1);
                }
            }
        }
    }
    return shape;
}

/// A band of n × m cells with a half turn: one-sided, so its orientation cannot be consistent.
inline Shape moebius(int n, int m) {
    Shape shape;
    for (int i = 0; i < n; ++i) {
        const double u = 2.0 * std::numbers::pi * i / n;
        for (int j = 0; j <= m; ++j) {
            const double w = static_cast<double>(j) / m - 0.5;
            const double r = 2.0 + w * std::cos(u / 2.0);
            shape.points.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2.0));
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const auto node = [&](int k, int l) { return k < n ? k * (m + 1) + l : m - l; };
            shape.add_quad(node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1));
        }
    }
    return shape;
}

/// Two triangulated half planes that meet along y = 0 at the given turn (degrees); nx cells along, ny away on each side.
/// Points (i, j), j = −ny … ny, have the index (j + ny)·(nx + 1) + i.
inline Shape roof(int nx, int ny, double turn) {
    Shape shape = grid(nx, 2 * ny);
    const double slope = turn * std::numbers::pi / 360.0;
    for (Point& p : shape.points) {
        const double y = p.y() - ny;
        p = {p.x(), y * std::cos(slope), -std::abs(y) * std::sin(slope)};
    }
    return shape;
}

/// Both shapes as one, with nothing shared.
inline Shape joined(Shape a, const Shape& b) {
    const auto offset = static_cast<std::int32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

/// The shape scaled, then moved.
inline Shape placed(Shape shape, double scale, const Point& offset) {
    for (Point& p : shape.points) p = scale * p + offset;
    return shape;
}

}  // namespace anisoquad::shapes
