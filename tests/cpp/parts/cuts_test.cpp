#include "parts/cuts.h"

#include <gtest/gtest.h>

namespace anisoquad {
namespace {

TEST(Cuts, AreNearOnlyWithinTheBoxThatTheyCut) {
    Cuts cuts;
    EXPECT_TRUE(cuts.empty());
    EXPECT_FALSE(cuts.is_near({1.0, 0.0, 0.0}, 1e9));
    cuts.add(0, 1.0, {Point(0.0, 0.0, 0.0), Point(2.0, 1.0, 1.0)});
    EXPECT_FALSE(cuts.empty());
    EXPECT_TRUE(cuts.is_near({1.0, 0.5, 0.5}, 0.0));
    EXPECT_TRUE(cuts.is_near({1.3, 0.5, 0.5}, 0.4));
    EXPECT_FALSE(cuts.is_near({1.3, 0.5, 0.5}, 0.2));
    EXPECT_TRUE(cuts.is_near({1.0, 1.3, 0.5}, 0.4));  // just outside of the box
    EXPECT_FALSE(cuts.is_near({1.0, 1.5, 0.5}, 0.4));
    cuts.add(2, -3.0, {Point(-1.0, -1.0, -4.0), Point(1.0, 1.0, -2.0)});
    EXPECT_TRUE(cuts.is_near({0.0, 0.0, -3.1}, 0.2));
    EXPECT_TRUE(cuts.is_near({1.0, 0.5, 0.5}, 0.0));
}

}  // namespace
}  // namespace anisoquad
