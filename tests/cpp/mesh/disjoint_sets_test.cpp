#include "mesh/disjoint_sets.h"

#include <gtest/gtest.h>

namespace anisoquad {
namespace {

TEST(DisjointSets, EachNumberIsASetOfItsOwnAtFirst) {
    DisjointSets sets(4);
    for (std::int32_t i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, ASetIsKnownByItsLowestNumber) {
    DisjointSets sets(6);
    EXPECT_TRUE(sets.unite(5, 3));
    EXPECT_TRUE(sets.unite(4, 1));
    EXPECT_TRUE(sets.unite(3, 4));
    EXPECT_FALSE(sets.unite(5, 1));
    for (const std::int32_t i : {1, 3, 4, 5}) EXPECT_EQ(sets.find(i), 1);
    EXPECT_EQ(sets.find(0), 0);
    EXPECT_EQ(sets.find(2), 2);
}

}  // namespace
}  // namespace anisoquad
