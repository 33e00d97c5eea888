#include "input/spatial_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace anisoquad {
namespace {

constexpr int kBits = 21;  ///< per axis: three of them fill 64 bits

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The bits of x, two free bits after each.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | (x << 32)) & 0x001f00000000ffffULL;
    x = (x | (x << 16)) & 0x001f0000ff0000ffULL;
    x = (x | (x << 8)) & 0x100f00f00f00f00fULL;
    x = (x | (x << 4)) & 0x10c30c30c30c30c3ULL;
    return (x | (x << 2)) & 0x1249249249249249ULL;
}

std::vector<std::int32_t> vertices_along_curve(std::span<const Point> points) {
    Eigen::AlignedBox3d box;
    for (const Point& p : points) box.extend(p);
    const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    const double scale = extent > 0.0 ? ((1 << kBits) - 1) / extent : 0.0;
    struct Key {
        std::uint64_t code;
        std::int32_t vertex;
    };
    std::vector<Key> keys;
    keys.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point cell = scale * (points[i] - box.min());
        std::uint64_t code = 0;
        for (int axis = 0; axis < 3; ++axis) code |= spread_bits(static_cast<std::uint64_t>(cell[axis])) << axis;
        keys.push_back({code, static_cast<std::int32_t>(i)});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.code != b.code ? a.code < b.code : a.vertex < b.vertex; });
    std::vector<std::int32_t> order;
    order.reserve(keys.size());
    for (const Key& key : keys) order.push_back(key.vertex);
    return order;
}

}  // namespace

SpatialOrder spatial_order(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles) {
    SpatialOrder order;
    order.vertex = vertices_along_curve(points);
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
