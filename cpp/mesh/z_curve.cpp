#include "mesh/z_curve.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>

#include "parallel.h"

namespace anisoquad {
namespace {

constexpr int kBits = 21;  ///< per axis: three of them fill 64 bits

/// The bits of x, two free bits after each.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | (x << 32)) & 0x001f00000000ffffULL;
    x = (x | (x << 16)) & 0x001f0000ff0000ffULL;
    x = (x | (x << 8)) & 0x100f00f00f00f00fULL;
    x = (x | (x << 4)) & 0x10c30c30c30c30c3ULL;
    return (x | (x << 2)) & 0x1249249249249249ULL;
}

}  // namespace

std::vector<std::int32_t> order_along_z_curve(std::int32_t count, const std::function<Point(std::int32_t)>& point) {
    using Box = Eigen::AlignedBox3d;
    const auto box_of = [&](std::int32_t first, std::int32_t last) {
        Box box;
        for (std::int32_t i = first; i < last; ++i) box.extend(point(i));
        return box;
    };
    const Box box = reduce_blocks(count, Box(), box_of, [](const Box& a, const Box& b) { return a.merged(b); });
    const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    const double scale = extent > 0.0 ? ((1 << kBits) - 1) / extent : 0.0;
    struct Key {
        std::uint64_t code;
        std::int32_t point;
    };
    std::vector<Key> keys(static_cast<std::size_t>(count));
    for_each(count, [&](std::int32_t i) {
        const Point cell = scale * (point(i) - box.min());
        std::uint64_t code = 0;
        for (int axis = 0; axis < 3; ++axis) code |= spread_bits(static_cast<std::uint64_t>(cell[axis])) << axis;
        keys[static_cast<std::size_t>(i)] = {code, i};
    });
    tbb::parallel_sort(keys.begin(), keys.end(),
                       [](const Key& a, const Key& b) { return a.code != b.code ? a.code < b.code : a.point < b.point; });
    std::vector<std::int32_t> order;
    order.reserve(keys.size());
    for (const Key& key : keys) order.push_back(key.point);
    return order;
}

std::vector<std::int32_t> order_along_z_curve(std::span<const Point> points) {
    return order_along_z_curve(static_cast<std::int32_t>(points.size()),
                               [&](std::int32_t i) { return points[static_cast<std::size_t>(i)]; });
}

}  // namespace anisoquad
