#include "cad/path_edges.h"

#include <gtest/gtest.h>

namespace anisoquad::cad {
namespace {

TEST(PathEdges, FindsTheEdgeAndItsParametersInTheOrderAskedFor) {
    const std::vector<EdgePath> paths{{{4, 7, 2}, {0.0, 0.5, 1.0}}, {}, {{2, 3}, {5.0, 6.0}}};
    const PathEdges edges(paths);
    EXPECT_EQ(edges.find(2, 7).edge, 0);
    EXPECT_DOUBLE_EQ(edges.find(2, 7).parameter[0], 1.0);
    EXPECT_DOUBLE_EQ(edges.find(2, 7).parameter[1], 0.5);
    EXPECT_DOUBLE_EQ(edges.find(7, 2).parameter[0], 0.5);
    EXPECT_EQ(edges.find(3, 2).edge, 2);
    EXPECT_EQ(edges.find(4, 2).edge, -1) << "ends of the path, but no step of it";
    EXPECT_EQ(edges.find(8, 9).edge, -1);
}

TEST(PathEdges, TellsAllEdgesAtOnePlace) {
    const std::vector<EdgePath> paths{{{1, 2, 3}, {0.0, 1.0, 2.0}}, {{3, 2}, {0.0, 1.0}}};
    const PathEdges edges(paths);
    const auto all = [&](std::int32_t a, std::int32_t b) {
        std::vector<std::int32_t> found;
        edges.for_each(a, b, [&](std::int32_t edge) { found.push_back(edge); });
        return found;
    };
    EXPECT_EQ(all(3, 2), (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(all(1, 2), (std::vector<std::int32_t>{0}));
    EXPECT_TRUE(all(1, 3).empty());
}

}  // namespace
}  // namespace anisoquad::cad
