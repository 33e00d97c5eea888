#include "parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace anisoquad {
namespace {

TEST(Parallel, BlocksCoverAllOnce) {
    for (const std::int32_t n : {0, 1, kBlock - 1, kBlock, kBlock + 1, 5 * kBlock + 7}) {
        std::vector<int> calls(static_cast<std::size_t>(n), 0);
        for_each(n, [&](std::int32_t i) { ++calls[static_cast<std::size_t>(i)]; });
        EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), n);
    }
}

TEST(Parallel, ReductionsAreTheSameForAnyNumberOfThreads) {
    const auto sum = [](std::int32_t first, std::int32_t last) {
        double s = 0.0;
        for (std::int32_t i = first; i < last; ++i) s += std::sin(i) * 1e-3;
        return s;
    };
    const auto all = [&] { return reduce_blocks(20 * kBlock + 3, 0.0, sum, std::plus<>()); };
    const double alone = with_threads(1, all);
    for (const int threads : {0, 2, 3}) EXPECT_EQ(with_threads(threads, all), alone);
}

TEST(Parallel, ErrorsReachTheCaller) {
    const auto fail = [](std::int32_t first, std::int32_t) {
        if (first > 0) throw std::runtime_error("no");
    };
    EXPECT_THROW(with_threads(2, [&] { for_blocks(3 * kBlock, fail); }), std::runtime_error);
}

}  // namespace
}  // namespace anisoquad
