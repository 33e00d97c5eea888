#include "picking/preview_rows.h"

#include <gtest/gtest.h>

#include <set>

#include "errors.h"
#include "quad_mesh.h"
#include "stages.h"

namespace anisoquad {
namespace {

TEST(PreviewRows, AreTheRowsThatAreBuilt) {
    const shapes::Shape shape = shapes::grid(24, 16);
    const std::vector<Source> sources{stages::source(stages::path(0, 24, 1), {{2, 3}, {2, 2}})};
    const std::vector<RowEdge> edges = preview_rows(shape.points, shape.triangles, sources, {});
    const QuadMeshResult mesh = quad_mesh(shape.points, shape.triangles, sources, {});
    std::set<std::int32_t> passes;
    double highest = 0.0;
    for (const RowEdge& edge : edges) {
        passes.insert(edge.pass);
        for (const Point& p : edge.ends) highest = std::max(highest, p.y());
    }
    EXPECT_EQ(passes, (std::set<std::int32_t>{1, 2}));
    double highest_in_rows = 0.0;
    std::size_t row_quads = 0;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        if (mesh.row[q] == 0) continue;
        ++row_quads;
        for (const std::int32_t v : mesh.quads[q])
            highest_in_rows = std::max(highest_in_rows, mesh.points[static_cast<std::size_t>(v)].y());
    }
    EXPECT_NEAR(highest, highest_in_rows, 0.5);
    EXPECT_GE(edges.size(), 2 * row_quads);
}

TEST(PreviewRows, ALineWithoutPassesHasNone) {
    const shapes::Shape shape = shapes::grid(12, 8);
    const std::vector<Source> sources{stages::source(stages::path(0, 12, 1), {})};
    EXPECT_TRUE(preview_rows(shape.points, shape.triangles, sources, {}).empty());
    EXPECT_THROW(preview_rows(shape.points, shape.triangles, std::vector<Source>{stages::source({0, 5})}, {}), Error);
}

}  // namespace
}  // namespace anisoquad
