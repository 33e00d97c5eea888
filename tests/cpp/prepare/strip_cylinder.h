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

}  // namespace anisoquad
