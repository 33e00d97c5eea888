#include "options.h"

#include <gtest/gtest.h>

#include "errors.h"

namespace anisoquad {
namespace {

std::vector<int> ratios(int anisotropy) {
    std::vector<int> result;
    for (const Pass& pass : passes_for_anisotropy(anisotropy)) result.push_back(pass.ratio);
    return result;
}

TEST(PassesForAnisotropy, FollowsThePapersExamples) {
    EXPECT_EQ(ratios(1), std::vector<int>{});
    EXPECT_EQ(ratios(3), (std::vector<int>{3}));
    EXPECT_EQ(ratios(5), (std::vector<int>{5}));
    EXPECT_EQ(ratios(6), (std::vector<int>{3, 2}));
    EXPECT_EQ(ratios(8), (std::vector<int>{4, 2}));
    EXPECT_EQ(ratios(16), (std::vector<int>{4, 2, 2}));
    EXPECT_EQ(ratios(32), (std::vector<int>{4, 2, 2, 2}));
}

TEST(PassesForAnisotropy, RejectsLessThanOne) {
    try {
        passes_for_anisotropy(0);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_option);
    }
}

}  // namespace
}  // namespace anisoquad
