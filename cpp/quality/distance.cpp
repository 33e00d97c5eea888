#include "quality/distance.h"

#include <algorithm>
#include <vector>

namespace anisoquad {

double distance_to(const ReferenceSurface& surface, std::span<const Point> points,
                   std::span<const std::array<std::int32_t, 3>> triangles) {
    double largest = 0.0;
    std::vector<char> seen(points.size(), 0);
    std::int32_t hint = -1;  // triangles near each other in memory are near each other in space
    const auto look = [&](const Point& p) {
        const SurfacePoint closest = surface.closest(p, ReferenceSurface::kAnyPatch, hint);
        hint = closest.facet;
        largest = std::max(largest, closest.distance);
    };
    for (const auto& t : triangles) {
        const Point& a = points[static_cast<std::size_t>(t[0])];
        const Point& b = points[static_cast<std::size_t>(t[1])];
        const Point& c = points[static_cast<std::size_t>(t[2])];
        look((a + b + c) / 3.0);
        look(0.5 * (a + b));
        look(0.5 * (b + c));
        look(0.5 * (c + a));
        for (const std::int32_t v : t) {
            if (seen[static_cast<std::size_t>(v)]) continue;
            seen[static_cast<std::size_t>(v)] = 1;
            look(points[static_cast<std::size_t>(v)]);
        }
    }
    return largest;
}

}  // namespace anisoquad
