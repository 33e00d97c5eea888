#include "quality/distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel.h"

namespace anisoquad {

double distance_to(const FacetTree& surface, const FacetTree& triangles, const Context& context) {
    std::vector<std::int32_t> first_facet(triangles.point_count(), -1);  // that looks at the point
    for (std::int32_t f = triangles.count(); f-- > 0;) {
        for (const std::int32_t v : triangles.facet(f)) first_facet[static_cast<std::size_t>(v)] = f;
    }
    const auto largest2_of = [&](std::int32_t first, std::int32_t last) {
        double largest2 = 0.0;
        std::int32_t hint = -1;  // triangles near each other in memory are near each other in space
        const auto look = [&](const Point& p) {
            // What is within the largest distance so far can't make it larger.
            const FacetTree::Hit closest = surface.closest_or_within(p, FacetTree::kAnyPatch, hint, largest2);
            hint = closest.facet;
            if (hint >= 0) largest2 = std::max(largest2, closest.distance2);
        };
        for (std::int32_t f = first; f < last; ++f) {
            const auto& t = triangles.facet(f);
            look((triangles.point(t[0]) + triangles.point(t[1]) + triangles.point(t[2])) / 3.0);
            for (int k = 0; k < 3; ++k) {
                const std::int32_t a = t[static_cast<std::size_t>(k)];
                const std::int32_t b = t[static_cast<std::size_t>((k + 1) % 3)];
                if (triangles.neighbour(f, k) < f) look(0.5 * (triangles.point(a) + triangles.point(b)));
                if (first_facet[static_cast<std::size_t>(a)] == f) look(triangles.point(a));
            }
        }
        return largest2;
    };
    const double largest2 =
        reduce_blocks(triangles.count(), context, 0.0, largest2_of, [](double a, double b) { return std::max(a, b); });
    return std::sqrt(largest2);
}

}  // namespace anisoquad
