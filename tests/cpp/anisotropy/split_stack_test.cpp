#include "anisotropy/split_stack.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace anisoquad {
namespace {

constexpr int kColumns = 20;

/// Two rows over a grid whose rows are `height` high and whose columns are 1 wide.
struct Rows {
    SurfaceMesh mesh;
    RowStack stack;

    explicit Rows(double height = 0.1) : mesh(shapes::grid(kColumns, 2, 1.0, height).mesh()) {
        for (int j = 0; j <= 2; ++j) {
            stack.layers.emplace_back();
            for (int i = 0; i <= kColumns; ++i) stack.layers.back().emplace_back(j * (kColumns + 1) + i);
        }
        stack.pass_of_row = {1, 1};
        stack.rows_before = 1;
        stack.source = 3;
        stack.stopped = "too close";
        stack.misfit.assign(kColumns, 0);
    }
};

/// Columns of each part, negative where it stays behind.
std::vector<int> columns(const std::vector<RowStack>& parts) {
    std::vector<int> all;
    for (const RowStack& part : parts) all.push_back(static_cast<int>(part.columns()) * (part.is_running ? 1 : -1));
    return all;
}

TEST(SplitStack, ColumnsThatDoNotFitStayBehindWithTheRowsBelow) {
    Rows p;
    p.stack.misfit[8] = p.stack.misfit[9] = 1;
    const auto parts = split_stack(p.mesh, p.stack, 4);
    ASSERT_EQ(columns(parts), (std::vector<int>{8, -2, 10}));
    for (const RowStack& part : parts) {
        EXPECT_EQ(part.rows(), 2u);
        EXPECT_EQ(part.rows_before, 1u);
        EXPECT_EQ(part.source, 3);
        EXPECT_EQ(part.pass_of_row, p.stack.pass_of_row);
        EXPECT_EQ(part.stopped, part.is_running ? "" : "too close");
    }
    for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(parts[0].layers[j].back(), parts[1].layers[j].front());
        EXPECT_EQ(parts[1].layers[j].back(), parts[2].layers[j].front());
        EXPECT_EQ(parts[1].layers[j].front(), p.stack.layers[j][8]);
    }
}

TEST(SplitStack, PartsThatAreTooShortStayBehindToo) {
    Rows p;
    p.stack.misfit[3] = p.stack.misfit[15] = 1;
    EXPECT_EQ(columns(split_stack(p.mesh, p.stack, 5)), (std::vector<int>{-4, 11, -5}));
    EXPECT_TRUE(split_stack(p.mesh, p.stack, 12).empty());
}

TEST(SplitStack, WithoutKnowledgeOfColumnsNothingIsSplit) {
    Rows p;
    EXPECT_TRUE(split_stack(p.mesh, p.stack, 1).empty());
    p.stack.misfit.clear();
    EXPECT_TRUE(split_stack(p.mesh, p.stack, 1).empty());
}

TEST(SplitStack, WhatStaysBehindIsWideForTheHeightOfTheRows) {
    Rows p(1.0);
    p.stack.misfit[10] = 1;
    EXPECT_EQ(columns(split_stack(p.mesh, p.stack, 2)), (std::vector<int>{8, -5, 7}));
    p.stack.misfit.assign(kColumns, 0);
    p.stack.misfit[0] = 1;
    EXPECT_EQ(columns(split_stack(p.mesh, p.stack, 2)), (std::vector<int>{-4, 16}));
}

TEST(SplitStack, AClosedStackIsOpenedWhereItStays) {
    Rows p;
    for (auto& layer : p.stack.layers) layer.back() = layer.front();
    p.stack.closed = true;
    p.stack.misfit[0] = p.stack.misfit[kColumns - 1] = 1;
    const auto parts = split_stack(p.mesh, p.stack, 4);
    ASSERT_EQ(columns(parts), (std::vector<int>{-2, 18}));
    EXPECT_EQ(parts[0].layers[1],
              (std::vector<Vertex>{p.stack.layers[1][kColumns - 1], p.stack.layers[1][0], p.stack.layers[1][1]}));
    EXPECT_FALSE(parts[0].closed || parts[1].closed);
}

TEST(JoinStacks, PartsWithEquallyManyRowsAreOneAgain) {
    Rows p;
    p.stack.misfit[8] = 1;
    auto parts = split_stack(p.mesh, p.stack, 4);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(join_stacks(parts).at(0).layers, p.stack.layers);
    EXPECT_EQ(join_stacks(parts).size(), 1u);
    // One row more on the last part.
    parts[2].layers.push_back(parts[2].top());
    parts[2].pass_of_row.push_back(1);
    EXPECT_EQ(join_stacks(parts).size(), 2u);
    // Stacks that were not cut off each other have a line between them.
    parts[0].goes_on = false;
    EXPECT_EQ(join_stacks(parts).size(), 3u);
}

}  // namespace
}  // namespace anisoquad
