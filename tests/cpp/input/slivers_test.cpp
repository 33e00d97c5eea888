#include "input/slivers.h"

#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

/// A square of diagonal 1 whose middle line has a sliver on its lower side, its tip a height above the line.
shapes::Shape square_with_sliver(double height, double at = 0.5) {
    const double side = std::sqrt(0.5);
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}, {0, side / 2, 0}, {side, side / 2, 0}};
    shape.points.emplace_back(at * side, side / 2 + height, 0.0);
    shape.triangles = {{0, 1, 5}, {0, 5, 4}, {4, 5, 6}, {4, 6, 3}, {3, 6, 2}, {6, 5, 2}};
    return shape;
}

bool has_edge(const SurfaceMesh& mesh, std::int32_t a, std::int32_t b) {
    return mesh.find_halfedge(Vertex(a), Vertex(b)).is_valid();
}

TEST(Slivers, HaveTheirLongestEdgeTurned) {
    SurfaceMesh mesh = square_with_sliver(1e-5).mesh();
    EXPECT_EQ(turn_slivers(mesh, 1.0, {}, {}), (std::vector<Face>{Face(1), Face(2)}));
    EXPECT_FALSE(has_edge(mesh, 4, 5));
    EXPECT_TRUE(has_edge(mesh, 0, 6));
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, {}).empty());
}

TEST(Slivers, AreNotTrianglesThickerThanAHair) {
    SurfaceMesh mesh = square_with_sliver(2e-4).mesh();
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, {}).empty());
}

TEST(Slivers, AreNotTrianglesWithAShortEdge) {
    SurfaceMesh mesh = square_with_sliver(1e-5, 0.01).mesh();
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, {}).empty());
}

TEST(Slivers, KeepEdgesThatTheUserNamed) {
    Options options;
    options.feature_edges = {{5, 4}};
    SurfaceMesh mesh = square_with_sliver(1e-5).mesh();
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, options).empty());
    EXPECT_TRUE(turn_slivers(mesh, 1.0, std::vector<Source>{{{4, 5}, {}, Sides::both}}, {}).empty());
    EXPECT_TRUE(has_edge(mesh, 4, 5));
}

TEST(Slivers, AreThinBesideTheModel) {
    SurfaceMesh mesh = square_with_sliver(2e-4).mesh();
    EXPECT_FALSE(turn_slivers(mesh, 10.0, {}, {}).empty());
}

/// Below the line lies nothing: turning would make a triangle outside of the surface.
TEST(Slivers, StayOnABoundary) {
    shapes::Shape shape = square_with_sliver(1e-5);
    shape.triangles.erase(shape.triangles.begin(), shape.triangles.begin() + 2);
    SurfaceMesh mesh = shape.mesh();
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, {}).empty());
}

/// The neighbour is a sliver too and reaches beyond the edge: one of the new triangles would face backwards.
TEST(Slivers, AreNotTurnedOverTheirNeighbour) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {0.7, 0, 0}, {0.35, 4e-5, 0}, {-0.5, -1e-5, 0}, {0.35, 0.5, 0}};
    shape.triangles = {{1, 0, 3}, {0, 1, 2}, {0, 2, 4}, {2, 1, 4}};
    SurfaceMesh mesh = shape.mesh();
    EXPECT_TRUE(turn_slivers(mesh, 1.0, {}, {}).empty());
}

/// A row of slivers that lie on each other: each turn leaves the next one to be turned.
TEST(Slivers, OfSeveralLayersAreAllTurned) {
    const double side = std::sqrt(0.5);
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}, {side / 3, 1e-5, 0}, {side / 2, 2e-5, 0}};
    // Slivers {0, 1, 4} and {4, 1, 5}, below them a square.
    shape.points.emplace_back(side / 2, -side, 0);
    shape.triangles = {{0, 6, 1}, {0, 1, 4}, {4, 1, 5}, {0, 4, 3}, {4, 5, 3}, {3, 5, 2}, {5, 1, 2}};
    SurfaceMesh mesh = shape.mesh();
    EXPECT_FALSE(turn_slivers(mesh, 1.0, {}, {}).empty());
    EXPECT_FALSE(has_edge(mesh, 0, 1));
    EXPECT_FALSE(has_edge(mesh, 4, 1));
    EXPECT_TRUE(has_edge(mesh, 6, 5));
    EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace anisoquad
