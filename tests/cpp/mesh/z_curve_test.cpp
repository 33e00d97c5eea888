#include "mesh/z_curve.h"

#include <gtest/gtest.h>

namespace anisoquad {
namespace {

TEST(ZCurve, VisitsTheQuartersOfASquareInTurn) {
    std::vector<Point> points;
    for (int j = 3; j >= 0; --j) {
        for (int i = 3; i >= 0; --i) points.emplace_back(i, j, 0.0);
    }
    const std::vector<std::int32_t> order = order_along_z_curve(points);
    const std::vector<std::pair<int, int>> wanted{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {3, 0}, {2, 1}, {3, 1},
                                                  {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 2}, {3, 2}, {2, 3}, {3, 3}};
    ASSERT_EQ(order.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_EQ(points[static_cast<std::size_t>(order[k])], Point(wanted[k].first, wanted[k].second, 0.0));
}

TEST(ZCurve, PointsOfOneCellKeepTheirOrder) {
    const std::vector<Point> points{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1e-9, 0.0, 0.0}};
    EXPECT_EQ(order_along_z_curve(points), (std::vector<std::int32_t>{1, 3, 0, 2}));
}

}  // namespace
}  // namespace anisoquad
