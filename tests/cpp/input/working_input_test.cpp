#include "input/working_input.h"

#include <gtest/gtest.h>

#include "mesh/arrays.h"
#include "shapes.h"

namespace anisoquad {
namespace {

shapes::Shape far_grid() { return shapes::placed(shapes::grid(6, 4), 50.0, Point(1000.0, -300.0, 7.0)); }

TEST(WorkingInput, HasDiagonalOneAtTheOrigin) {
    const shapes::Shape shape = far_grid();
    const WorkingInput input(shape.points, shape.triangles, false, no_context());
    Point low = input.points()[0];
    Point high = low;
    for (const Point& p : input.points()) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    EXPECT_NEAR((high - low).norm(), 1.0, 1e-12);
    EXPECT_NEAR((low + high).norm(), 0.0, 1e-12);
    EXPECT_NEAR(input.scale(), 50.0 * std::sqrt(6.0 * 6.0 + 4.0 * 4.0), 1e-9);
}

TEST(WorkingInput, GivesPlacesBackAsVerticesOfTheUser) {
    const shapes::Shape shape = far_grid();
    WorkingInput input(shape.points, shape.triangles, false, no_context());
    const std::vector<std::int32_t> rank(input.rank().begin(), input.rank().end());
    ASSERT_EQ(rank.size(), shape.points.size());
    const SurfaceMesh mesh = from_arrays(input.points(), input.triangles());
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(rank.size()); ++v) {
        const std::int32_t place = rank[static_cast<std::size_t>(v)];
        EXPECT_EQ(input.input_vertex(place), v);
        EXPECT_EQ(input.place_of(mesh, Vertex(place)), shape.points[static_cast<std::size_t>(v)]);  // not only nearly
    }
    EXPECT_EQ(input.input_vertex(-1), -1);
}

TEST(WorkingInput, PutsIdsInOrder) {
    const shapes::Shape shape = far_grid();
    WorkingInput input(shape.points, shape.triangles, false, no_context());
    const std::vector<std::int32_t> rank(input.rank().begin(), input.rank().end());
    std::vector<Source> sources{{{3, 4, 5}, {}, Sides::both}};
    Options options;
    options.feature_edges = {{8, 9}};
    for (std::size_t v = 0; v < shape.points.size(); ++v) options.vertex_size.push_back(static_cast<double>(v));
    input.put_in_order(sources, options);
    EXPECT_EQ(sources[0].vertices, (std::vector<std::int32_t>{rank[3], rank[4], rank[5]}));
    EXPECT_EQ(options.feature_edges[0], (std::array<std::int32_t, 2>{rank[8], rank[9]}));
    EXPECT_EQ(options.vertex_size[static_cast<std::size_t>(rank[11])], 11.0);
    EXPECT_TRUE(input.rank().empty());
}

TEST(WorkingInput, KeepsTheOrderWhereAsked) {
    const shapes::Shape shape = far_grid();
    WorkingInput input(shape.points, shape.triangles, true, no_context());
    EXPECT_TRUE(input.rank().empty());
    EXPECT_TRUE(std::equal(shape.triangles.begin(), shape.triangles.end(), input.triangles().begin(), input.triangles().end()));
    EXPECT_EQ(input.input_vertex(5), 5);
}

TEST(WorkingInput, TrianglesFollowSliversThatAreTurned) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 1e-5, 0}, {5, -10, 0}};
    shape.triangles = {{0, 5, 1}, {0, 1, 4}, {0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
    WorkingInput input(shape.points, shape.triangles, false, no_context());
    SurfaceMesh mesh = from_arrays(input.points(), input.triangles());
    std::vector<Source> sources;
    Options options;
    input.put_in_order(sources, options);
    EXPECT_EQ(input.turn_slivers_of(mesh, sources, options), 2U);
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const auto& triangle = input.triangles()[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.face(mesh.find_halfedge(Vertex(triangle[k]), Vertex(triangle[(k + 1) % 3]))), Face(i));
    }
}

/// A needle between two triangles, the square's upper right one and its lower left one.
TEST(WorkingInput, TrianglesOfNeedlesAreTakenOut) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 5, 0}, {5 + 1e-5, 5, 0}};
    shape.triangles = {{0, 1, 5}, {0, 5, 4}, {1, 2, 5}, {2, 4, 5}, {2, 3, 4}, {3, 0, 4}};
    WorkingInput input(shape.points, shape.triangles, false, no_context());
    SurfaceMesh mesh = from_arrays(input.points(), input.triangles());
    std::vector<Source> sources;
    Options options;
    input.put_in_order(sources, options);
    EXPECT_EQ(input.collapse_needles_of(mesh, sources, options, no_context()), 1);
    ASSERT_EQ(input.triangles().size(), 4U);
    ASSERT_EQ(mesh.face_slots(), 4);
    EXPECT_EQ(input.points().size(), 6U) << "vertices keep their places";
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const auto& triangle = input.triangles()[static_cast<std::size_t>(i)];
        EXPECT_EQ(*std::min_element(triangle.begin(), triangle.end()), triangle[0]);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.face(mesh.find_halfedge(Vertex(triangle[k]), Vertex(triangle[(k + 1) % 3]))), Face(i));
    }
    EXPECT_EQ(input.collapse_needles_of(mesh, sources, options, no_context()), 0);
}

}  // namespace
}  // namespace anisoquad
