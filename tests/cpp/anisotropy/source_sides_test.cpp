#include "anisotropy/source_sides.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "qmorph/front.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

std::vector<std::int32_t> ids(const RowStack& stack) {
    std::vector<std::int32_t> all;
    for (const Vertex v : stack.layers.at(0)) all.push_back(v.index());
    return all;
}

std::vector<std::int32_t> reversed(std::vector<std::int32_t> nodes) {
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
}

/// Empty stacks whose bases are front edges in a row.
std::vector<RowStack> stacks(const Prepared& p, const std::vector<Source>& sources) {
    std::vector<RowStack> all = source_sides(p.mesh, sources);
    for (const RowStack& stack : all) {
        EXPECT_EQ(stack.rows(), 0u);
        EXPECT_TRUE(stack.stopped.empty());
        for (std::size_t i = 0; i < stack.columns(); ++i) {
            const HalfEdge h = p.mesh.find_halfedge(stack.top()[i], stack.top()[i + 1]);
            EXPECT_TRUE(h.is_valid() && is_front(p.mesh, h));
        }
    }
    return all;
}

TEST(SourceSides, AnOpenSourceHasTwo) {
    for (const auto& line : {path(36, 44, 1), path(38, 42, 1), path(4, 76, 9)}) {  // across, inside, upwards
        const std::vector<Source> sources{source(line)};
        Prepared p(shapes::grid(8, 8), sources);
        const auto all = stacks(p, sources);
        ASSERT_EQ(all.size(), 2u);
        EXPECT_TRUE(all[0].left && !all[1].left);
        EXPECT_EQ(ids(all[0]), line);
        EXPECT_EQ(ids(all[1]), reversed(line));
        EXPECT_FALSE(all[0].closed || all[1].closed);
    }
}

TEST(SourceSides, TheUsersSideOnly) {
    for (const Sides sides : {Sides::left, Sides::right}) {
        const std::vector<Source> sources{source(path(36, 44, 1), {{2, 0}}, sides)};
        Prepared p(shapes::grid(8, 8), sources);
        const auto all = stacks(p, sources);
        ASSERT_EQ(all.size(), 1u);
        EXPECT_EQ(all[0].left, sides == Sides::left);
    }
}

TEST(SourceSides, TheOpenBoundaryHasNoRows) {
    for (const bool backwards : {false, true}) {
        const auto line = backwards ? reversed(path(0, 8, 1)) : path(0, 8, 1);
        const std::vector<Source> sources{source(line)};
        Prepared p(shapes::grid(8, 8), sources);
        const auto all = stacks(p, sources);
        ASSERT_EQ(all.size(), 1u);
        EXPECT_EQ(all[0].left, !backwards);
        EXPECT_EQ(ids(all[0]), path(0, 8, 1));
    }
}

TEST(SourceSides, AClosedSourceHasTwoClosedOnes) {
    const std::vector<Source> sources{source(ring(12, 3))};
    Prepared p(shapes::cylinder(12, 6), sources);
    const auto all = stacks(p, sources);
    ASSERT_EQ(all.size(), 2u);
    for (const RowStack& stack : all) {
        EXPECT_TRUE(stack.closed);
        EXPECT_EQ(stack.columns(), 12u);
        EXPECT_EQ(stack.top().front(), stack.top().back());
    }
}

TEST(SourceSides, ALineThatEndsOnTheSourceCutsItsSide) {
    Options options;
    options.feature_edges = {{40, 49}, {49, 58}, {58, 67}, {67, 76}};
    const std::vector<Source> sources{source(path(36, 44, 1))};
    Prepared p(shapes::grid(8, 8), sources, options);
    const auto all = stacks(p, sources);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(ids(all[0]), path(36, 40, 1));
    EXPECT_EQ(ids(all[1]), path(40, 44, 1));
    EXPECT_EQ(ids(all[2]), reversed(path(36, 44, 1)));
    EXPECT_TRUE(all[0].left && all[1].left && !all[2].left);
}

TEST(SourceSides, ALineThatEndsOnAClosedSourceOpensItsSide) {
    for (const int at : {0, 5}) {
        Options options;
        for (int j = 3; j < 6; ++j) options.feature_edges.push_back({12 * j + at, 12 * (j + 1) + at});
        const std::vector<Source> sources{source(ring(12, 3))};
        Prepared p(shapes::cylinder(12, 6), sources, options);
        const auto all = stacks(p, sources);
        ASSERT_EQ(all.size(), 2u);
        EXPECT_FALSE(all[0].closed);
        EXPECT_EQ(all[0].columns(), 12u);
        EXPECT_EQ(all[0].top().front(), Vertex(36 + at));
        EXPECT_EQ(all[0].top().back(), Vertex(36 + at));
        EXPECT_TRUE(all[1].closed);
    }
}

TEST(SourceSides, SourcesAreCountedAndThoseWithoutPassesSkipped) {
    const std::vector<Source> sources{source(path(18, 26, 1)), source(path(36, 44, 1), {}), source(path(54, 62, 1))};
    Prepared p(shapes::grid(8, 8), sources);
    const auto all = stacks(p, sources);
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].source, 0);
    EXPECT_EQ(all[3].source, 2);
}

}  // namespace
}  // namespace anisoquad
