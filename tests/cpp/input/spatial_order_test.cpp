#include "input/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "shapes.h"

namespace anisoquad {
namespace {

shapes::Shape shuffled(const shapes::Shape& shape, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::int32_t> id(shape.points.size());
    std::iota(id.begin(), id.end(), 0);
    std::shuffle(id.begin(), id.end(), random);
    shapes::Shape result;
    result.points.resize(id.size());
    for (std::size_t i = 0; i < id.size(); ++i) result.points[static_cast<std::size_t>(id[i])] = shape.points[i];
    for (auto t : shape.triangles) {
        for (std::int32_t& v : t) v = id[static_cast<std::size_t>(v)];
        result.triangles.push_back(t);
    }
    std::shuffle(result.triangles.begin(), result.triangles.end(), random);
    return result;
}

bool is_permutation(std::vector<std::int32_t> order, std::size_t n) {
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> all(n);
    std::iota(all.begin(), all.end(), 0);
    return order == all;
}

/// Mean distance in memory of the ends of the triangles' edges.
double spread(const shapes::Shape& shape, const std::vector<std::int32_t>& rank) {
    double sum = 0.0;
    for (const auto& t : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            sum += std::abs(rank[static_cast<std::size_t>(t[k])] - rank[static_cast<std::size_t>(t[(k + 1) % 3])]);
    }
    return sum / (3.0 * static_cast<double>(shape.triangles.size()));
}

TEST(SpatialOrder, OrdersAllVerticesAndTriangles) {
    const shapes::Shape shape = shuffled(shapes::grid(12, 9), 1);
    const SpatialOrder order = spatial_order(shape.points, shape.triangles);
    EXPECT_TRUE(is_permutation(order.vertex, shape.points.size()));
    EXPECT_TRUE(is_permutation(order.triangle, shape.triangles.size()));
    for (std::size_t i = 0; i < order.vertex.size(); ++i)
        EXPECT_EQ(order.rank[static_cast<std::size_t>(order.vertex[i])], static_cast<std::int32_t>(i));
}

TEST(SpatialOrder, NeighboursAreNearInMemory) {
    const shapes::Shape shape = shuffled(shapes::grid(64, 64), 2);
    std::vector<std::int32_t> as_given(shape.points.size());
    std::iota(as_given.begin(), as_given.end(), 0);
    EXPECT_LT(spread(shape, spatial_order(shape.points, shape.triangles).rank), 0.1 * spread(shape, as_given));
}

TEST(SpatialOrder, IsThatOfThePlacesNotOfTheInput) {
    const shapes::Shape shape = shapes::grid(10, 10);
    const SpatialOrder first = spatial_order(shape.points, shape.triangles);
    for (unsigned seed = 0; seed < 3; ++seed) {
        const shapes::Shape other = shuffled(shape, seed);
        const SpatialOrder second = spatial_order(other.points, other.triangles);
        for (std::size_t i = 0; i < first.vertex.size(); ++i)
            EXPECT_EQ(shape.points[static_cast<std::size_t>(first.vertex[i])],
                      other.points[static_cast<std::size_t>(second.vertex[i])]);
        for (std::size_t i = 0; i < first.triangle.size(); ++i) {
            const auto middle = [](const shapes::Shape& s, std::int32_t f) {
                Point sum = Point::Zero();
                for (const std::int32_t v : s.triangles[static_cast<std::size_t>(f)])
                    sum += s.points[static_cast<std::size_t>(v)];
                return sum;
            };
            EXPECT_TRUE(middle(shape, first.triangle[i]).isApprox(middle(other, second.triangle[i])));
        }
    }
}

TEST(SpatialOrder, FlatAndSinglePlacesHaveOne) {
    const std::vector<Point> points{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
    EXPECT_EQ(spatial_order(points, {}).vertex, (std::vector<std::int32_t>{0, 1}));
    EXPECT_TRUE(spatial_order({}, {}).vertex.empty());
}

}  // namespace
}  // namespace anisoquad
