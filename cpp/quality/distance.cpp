#include "quality/distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace anisoquad {

double distance_to(const FacetTree& surface, const FacetTree& triangles) {
    double largest2 = 0.0;
    std::int32_t hint = -1;  // triangles near each other in memory are near each other in space
    const auto look = [&](const Point& p) {
        // What is within the largest distance so far can't make it larger.
        const FacetTree::Hit closest = surface.closest_or_within(p, FacetTree::kAnyPatch, hint, largest2);
        hint = closest.facet;
        if (hint >= 0) largest2 = std::max(largest2, closest.distance2);
    };
    std::vector<char> seen(triangles.point_count(), 0);
    for (std::int32_t f = 0; f < triangles.count(); ++f) {
        const auto& t = triangles.facet(f);
        look((triangles.point(t[0]) + triangles.point(t[1]) + triangles.point(t[2])) / 3.0);
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = t[static_cast<std::size_t>(k)];
            const std::int32_t b = t[static_cast<std::size_t>((k + 1) % 3)];
            if (triangles.neighbour(f, k) < f) look(0.5 * (triangles.point(a) + triangles.point(b)));
            char& node_seen = seen[static_cast<std::size_t>(a)];
            if (!node_seen) look(triangles.point(a));
            node_seen = 1;
        }
    }
    return std::sqrt(largest2);
}

}  // namespace anisoquad
