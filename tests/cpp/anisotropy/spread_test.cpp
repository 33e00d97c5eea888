#include "anisotropy/spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace anisoquad {
namespace {

double cost(const std::vector<double>& value, const std::vector<double>& wanted, double reach) {
    double sum = 0.0;
    for (std::size_t i = 1; i < value.size(); ++i) {
        sum += std::pow(value[i] - value[i - 1], 2);
        if (i + 1 < value.size()) sum += std::pow((value[i] - wanted[i]) / reach, 2);
    }
    return sum;
}

TEST(Spread, TheEndsStayAndTheLeastSumIsFoundBetween) {
    const std::vector<double> wanted{1.0, 1.0, 2.0, 3.0, 1.0, 1.0, 4.0};
    std::vector<double> value{5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    spread(value, wanted, 3.0, false);
    EXPECT_EQ(value.front(), 5.0);
    EXPECT_EQ(value.back(), 1.0);
    const double least = cost(value, wanted, 3.0);
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        for (const double step : {-1e-3, 1e-3}) {
            std::vector<double> other = value;
            other[i] += step;
            EXPECT_GT(cost(other, wanted, 3.0), least) << "value " << i;
        }
    }
}

TEST(Spread, FarFromTheEndsTheWishIsFulfilled) {
    const std::vector<double> wanted(101, 2.0);
    std::vector<double> value(101, 0.0);
    value.back() = 7.0;
    spread(value, wanted, 3.0, false);
    EXPECT_NEAR(value[50], 2.0, 1e-6);
    EXPECT_LT(value[3], 1.5);
}

TEST(Spread, AClosedRowIsEvenedOutAndKeepsItsSum) {
    std::vector<double> value{0.0, 8.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  // the last is the first
    spread(value, value, 3.0, true);
    EXPECT_DOUBLE_EQ(value.front(), value.back());
    EXPECT_NEAR(std::accumulate(value.begin(), value.end() - 1, 0.0), 8.0, 1e-12);
    EXPECT_LT(*std::max_element(value.begin(), value.end()), 2.0);
}

}  // namespace
}  // namespace anisoquad
