#include "cleanup/patch_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cleanup/patch_mesh.h"
#include "cleanup/quad_shapes.h"

namespace anisoquad {
namespace {

Sides sides_of(const std::vector<int>& counts) {
    Sides sides;
    for (const int n : counts) sides.push_back(n);
    return sides;
}

/// One face with the patch's outline on a circle, in which the plan is carried out.
int irregular_nodes_of(const std::vector<int>& counts, PatchPlanner& planner, int budget) {
    const int n = sides_of(counts).sum();
    SurfaceMesh outline;
    std::vector<Vertex> nodes;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        nodes.push_back(outline.add_vertex({std::cos(angle), std::sin(angle), 0.0}));
    }
    std::vector<std::vector<Vertex>> lines;
    int start = 0;
    for (const int edges : counts) {
        std::vector<Vertex>& line = lines.emplace_back();
        for (int k = 0; k <= edges; ++k) line.push_back(nodes[static_cast<std::size_t>((start + k) % n)]);
        start += edges;
    }
    const Replacement patch = mesh_patch(outline, planner, lines, budget, 0.0);
    // Quads are counted at every node: corners of the patch have one, other nodes of the outline two.
    std::vector<int> at_outline(static_cast<std::size_t>(n), 0);
    std::vector<int> at_new(patch.nodes.size(), 0);
    for (const auto& quad : patch.quads) {
        for (const Vertex v : quad)
            ++(Replacement::is_new(v) ? at_new[Replacement::index(v)] : at_outline[static_cast<std::size_t>(v.index())]);
    }
    int irregular = 0;
    for (const int quads : at_new) irregular += quads != 4 ? 1 : 0;
    start = 0;
    for (const int edges : counts) {
        irregular += at_outline[static_cast<std::size_t>(start)] != 1 ? 1 : 0;
        for (int k = 1; k < edges; ++k) irregular += at_outline[static_cast<std::size_t>(start + k)] != 2 ? 1 : 0;
        start += edges;
    }
    return irregular;
}

TEST(PatchPlan, GridsAndStarsAreRecognised) {
    PatchPlanner planner;
    EXPECT_EQ(planner.plan(sides_of({3, 5, 3, 5}), 0).irregular, 0);
    EXPECT_EQ(planner.plan(sides_of({2, 2, 2}), 1).irregular, 1);
    EXPECT_EQ(planner.plan(sides_of({2, 2, 2, 2, 2}), 1).irregular, 1);
    EXPECT_EQ(planner.plan(sides_of({4, 4, 4, 4, 4, 4}), 2).irregular, 2);
}

TEST(PatchPlan, NothingIsPlannedWithTooSmallABudgetOrAnOddOutline) {
    PatchPlanner planner;
    EXPECT_FALSE(planner.plan(sides_of({3, 5, 3, 4}), 3).is_possible());
    EXPECT_FALSE(planner.plan(sides_of({3, 5, 4, 6}), 1).is_possible());
    EXPECT_FALSE(planner.plan(sides_of({2, 2, 2}), 0).is_possible());
}

TEST(PatchPlan, CarriedOutItHasAsManyIrregularNodesAsPromised) {
    PatchPlanner planner;
    int possible = 0;
    const auto check = [&](const std::vector<int>& counts) {
        const PatchPlan plan = planner.plan(sides_of(counts), 3);
        if (!plan.is_possible()) return;
        ++possible;
        EXPECT_EQ(irregular_nodes_of(counts, planner, 3), plan.irregular) << ::testing::PrintToString(counts);
    };
    for (int a = 1; a < 6; ++a) {
        for (int b = 1; b < 6; ++b) {
            for (int c = 1; c < 6; ++c) {
                check({a, b, c});
                for (int d = 1; d < 6; ++d) {
                    check({a, b, c, d});
                    check({a, b, c, d, 3});
                    check({a, b, c, d, 4, 2});
                }
            }
            check({a, b});
        }
    }
    EXPECT_GT(possible, 100);
}

}  // namespace
}  // namespace anisoquad
