#include "anisotropy/segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace anisoquad {
namespace {

int sum(const std::vector<int>& v) { return std::accumulate(v.begin(), v.end(), 0); }
int greatest(const std::vector<int>& v) { return *std::max_element(v.begin(), v.end()); }
int least(const std::vector<int>& v) { return *std::min_element(v.begin(), v.end()); }

TEST(Segmentation, RampsAsInThePapersFigure4) {
    EXPECT_EQ(segment_open(24, 4), (std::vector{1, 2, 3, 4, 4, 4, 3, 2, 1}));
    EXPECT_EQ(segment_open(9, 3), (std::vector{1, 2, 3, 2, 1}));
    EXPECT_EQ(segment_open(4, 2), (std::vector{1, 2, 1}));
}

TEST(Segmentation, OfOpenSourcesRisesAndFallsByOne) {
    for (int ratio = 1; ratio <= 8; ++ratio) {
        for (int edges = 1; edges <= 200; ++edges) {
            const std::vector<int> s = segment_open(edges, ratio);
            ASSERT_EQ(sum(s), edges);
            EXPECT_EQ(s.front(), 1);
            EXPECT_EQ(s.back(), 1);
            EXPECT_LE(greatest(s), ratio);
            EXPECT_GE(least(s), 1);
            if (edges >= ratio * ratio) {
                EXPECT_EQ(greatest(s), ratio);
            }
            const auto top = std::max_element(s.begin(), s.end());
            EXPECT_TRUE(std::is_sorted(s.begin(), top));
            EXPECT_TRUE(std::is_sorted(top, s.end(), std::greater<>()));
            for (std::size_t i = 1; i < s.size(); ++i) EXPECT_LE(std::abs(s[i] - s[i - 1]), 1);
        }
    }
}

TEST(Segmentation, RampsStartWithAsManyEdgesAsAskedFor) {
    EXPECT_EQ(segment_open(22, 4, {2, 2}), (std::vector{2, 3, 4, 4, 4, 3, 2}));
    EXPECT_EQ(segment_open(23, 4, {1, 2}), (std::vector{1, 2, 3, 4, 4, 4, 3, 2}));
    EXPECT_EQ(segment_open(8, 2, {2, 2}), (std::vector{2, 2, 2, 2}));
    for (int ratio = 2; ratio <= 6; ++ratio) {
        for (int front = 1; front <= ratio; ++front) {
            for (int back = 1; back <= ratio; ++back) {
                for (int edges = 1; edges <= 120; ++edges) {
                    const std::vector<int> s = segment_open(edges, ratio, {front, back});
                    ASSERT_EQ(sum(s), edges);
                    EXPECT_LE(greatest(s), ratio);
                    if (edges < 2 * ratio * ratio) continue;
                    EXPECT_EQ(greatest(s), ratio);
                    EXPECT_GE(s.front(), front);
                    EXPECT_GE(s.back(), back);
                    // None is thinner than both the ramps and the middle: its column would be too slim for the rows.
                    EXPECT_GE(least(s), std::min({front, back, ratio - 1}));
                }
            }
        }
    }
}

TEST(Segmentation, OfClosedSourcesIsEvenWithoutRamp) {
    for (int ratio = 2; ratio <= 8; ++ratio) {
        for (int edges = 3; edges <= 200; ++edges) {
            const std::vector<int> s = segment_closed(edges, ratio);
            ASSERT_EQ(sum(s), edges);
            EXPECT_LE(greatest(s) - least(s), 1);
            EXPECT_GE(s.size(), 3u);
            if (edges > 3) {
                EXPECT_EQ(s.size() % 2, 0u) << edges << " edges, ratio " << ratio;
            }
            if (edges >= 6 * ratio) {
                EXPECT_LE(greatest(s), ratio + 1);
                EXPECT_GE(greatest(s), ratio - 1);
            }
        }
    }
}

TEST(Segmentation, SegmentsThatAreNotAcceptedAreHalved) {
    const std::vector<int> s{1, 2, 3, 4, 4, 4, 3, 2, 1};
    EXPECT_EQ(refine_segments(s, [](int, int) { return true; }), s);
    EXPECT_EQ(refine_segments(s, [](int, int) { return false; }), std::vector<int>(24, 1));
    // A bend between edges 10 and 11: no segment runs over it, the others stay whole.
    const auto refined = refine_segments(s, [](int a, int b) { return b <= 11 || a >= 11; });
    EXPECT_EQ(sum(refined), 24);
    std::vector<int> ends;
    std::partial_sum(refined.begin(), refined.end(), std::back_inserter(ends));
    EXPECT_NE(std::find(ends.begin(), ends.end(), 11), ends.end());
    for (const int end : {1, 3, 6, 10, 14, 18, 21, 23, 24}) EXPECT_NE(std::find(ends.begin(), ends.end(), end), ends.end());
    EXPECT_LE(refined.size(), s.size() + 3);
}

}  // namespace
}  // namespace anisoquad
