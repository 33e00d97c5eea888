#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

struct Surface {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// An open cylinder as a CAD kernel tessellates it: one strip of `sides` long facets of the given height.
inline Surface strip_cylinder(int sides, int rings, double height) {
    Surface s;
    const double radius = 0.1;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < sides; ++i) {
            const double a = 2.0 * std::numbers::pi * i / sides;
            s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), height * j / rings);
        }
    }
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < sides; ++i) {
            const int a = j * sides + i;
            const int b = j * sides + (i + 1) % sides;
            s.triangles.push_back({a, b, b + sides});
            s.triangles.push_back({a, b + sides, a + sides});
        }
    }
    return s;
}

/// The nose of a tapered wing as a CAD kernel tessellates a loft: strips from root to tip round a parabola, the first ones beside
/// the leading edge far thinner than the others. The leading edge joins the points 0 and 1; radius 0.008 at the root, span 1.
inline Surface strip_nose() {
    Surface s;
    const auto add = [&](double side) {
        for (const double taper : {1.0, 0.6}) {
            const double x = taper * side * side / 0.016;
            s.points.emplace_back(x + (taper < 1.0 ? 0.25 : 0.0), taper < 1.0 ? 1.0 : 0.0, taper * side);
        }
        return static_cast<std::int32_t>(s.points.size()) - 2;
    };
    add(0.0);
    for (const double sign : {1.0, -1.0}) {
        std::int32_t a = 0;
        for (const double side : {0.0004, 0.0012, 0.0021, 0.003, 0.0042, 0.006, 0.0085, 0.012, 0.017, 0.025, 0.035}) {
            const std::int32_t b = add(sign * side);
            const std::int32_t low = sign > 0.0 ? a : b;
            const std::int32_t high = sign > 0.0 ? b : a;
            s.triangles.push_back({low, low + 1, high + 1});
            s.triangles.push_back({low, high + 1, high});
            a = b;
        }
    }
    return s;
}

}  // namespace anisoquad
