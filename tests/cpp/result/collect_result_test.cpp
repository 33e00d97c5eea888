#include "result/collect_result.h"

#include <gtest/gtest.h>

#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "result/stage_snapshot.h"
#include "shapes.h"

namespace anisoquad {
namespace {

/// A square of four points of the user, as one quad with a line on one side.
struct Square {
    shapes::Shape shape = shapes::placed(shapes::grid(1, 1), 3.0, Point(10.0, 0.0, 0.0));
    WorkingInput input{shape.points, shape.triangles, false, no_context()};
    SurfaceMesh mesh = from_arrays(input.points(), input.triangles());

    Square() {
        for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
            if (mesh.is_boundary(Edge(e))) continue;
            mesh.info(dissolve_edge(mesh, Edge(e))).patch = 5;
            break;
        }
        mesh.info(Edge(0)).line = 2;
    }
};

TEST(CollectResult, IsInTheUnitAndWithTheIdsOfTheUser) {
    Square square;
    const Vertex moved(0);
    square.mesh.position(moved) += Point(0.0, 0.0, 0.5);
    square.mesh.info(moved).input = -1;
    QuadMeshResult result;
    collect_result(square.mesh, square.input, result);
    ASSERT_EQ(result.points.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::int32_t input = result.node_input[i];
        if (input >= 0) {
            EXPECT_EQ(result.points[i], square.shape.points[static_cast<std::size_t>(input)]);
        } else {
            EXPECT_NEAR(result.points[i].z(), 0.5 * square.input.scale(), 1e-12);
        }
    }
    EXPECT_EQ(std::count(result.node_input.begin(), result.node_input.end(), -1), 1);
    EXPECT_EQ(result.quads.size(), 1U);
    EXPECT_EQ(result.patch, std::vector<std::int32_t>{5});
    ASSERT_EQ(result.line_edges.size(), 1U);
    EXPECT_EQ(result.line_edges[0][2], 2);
}

TEST(StageSnapshot, IsInTheUnitOfTheUser) {
    const Square square;
    const StageSnapshot stage = snapshot_of(square.mesh, square.input, "fill");
    EXPECT_EQ(stage.name, "fill");
    EXPECT_EQ(stage.faces.size(), 1U);
    EXPECT_EQ(stage.row, std::vector<std::int32_t>{0});
    for (const Point& p : stage.points) {
        EXPECT_NE(std::find(square.shape.points.begin(), square.shape.points.end(), p), square.shape.points.end());
    }
}

}  // namespace
}  // namespace anisoquad
