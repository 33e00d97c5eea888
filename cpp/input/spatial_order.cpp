#include "input/spatial_order.h"

#include <algorithm>
#include <numeric>

#include "mesh/z_curve.h"

namespace anisoquad {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

SpatialOrder spatial_order(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    SpatialOrder order;
    order.vertex = order_along_z_curve(points);
    order.rank.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) order.rank[at(order.vertex[i])] = static_cast<std::int32_t>(i);

    // Triangles by their first vertex (a counting sort), those of one vertex by the other two.
    const auto places = [&](std::int32_t triangle) {
        std::array<std::int32_t, 3> t{};
        for (std::size_t k = 0; k < 3; ++k) t[k] = order.rank[at(triangles[at(triangle)][k])];
        std::sort(t.begin(), t.end());
        return t;
    };
    std::vector<std::int32_t> first(points.size() + 1, 0);
    for (std::size_t f = 0; f < triangles.size(); ++f) ++first[at(places(static_cast<std::int32_t>(f))[0]) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    order.triangle.resize(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const auto triangle = static_cast<std::int32_t>(f);
        order.triangle[at(next[at(places(triangle)[0])]++)] = triangle;
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
        std::sort(order.triangle.begin() + first[v], order.triangle.begin() + first[v + 1],
                  [&](std::int32_t a, std::int32_t b) { return places(a) < places(b); });
    }
    return order;
}

}  // namespace anisoquad
