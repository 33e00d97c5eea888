#include "qmorph/sharp_corner.h"

#include <gtest/gtest.h>

#include <numbers>

#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

/// n triangles' width of a wedge from the corner, node 0; node 2i − 1 lies on its lower side, 2i on its upper one.
shapes::Shape wedge(int n, double degrees, double uneven = 1.0) {
    shapes::Shape shape;
    const double a = 0.5 * degrees * std::numbers::pi / 180.0;
    shape.points.emplace_back(0, 0, 0);
    for (int i = 1; i <= n; ++i) {
        shape.points.emplace_back(i * std::cos(a), -i * std::sin(a), 0.0);
        shape.points.emplace_back(uneven * i * std::cos(a), uneven * i * std::sin(a), 0.0);
    }
    shape.triangles.push_back({0, 1, 2});
    for (int i = 1; i < n; ++i) shape.add_quad(2 * i - 1, 2 * i + 1, 2 * i + 2, 2 * i, i % 2 == 1);
    return shape;
}

TEST(SharpCorner, GetsAQuadWithANewNodeBeyondItsNeighbours) {
    for (const double degrees : {12.0, 25.0, 38.0}) {
        Prepared p(wedge(6, degrees));
        EXPECT_EQ(fill_sharp_corners(p.mesh), 1);
        expect_sound(p);
        EXPECT_EQ(inverted_triangles(p), 0);
        EXPECT_NEAR(signed_area(p), input_area(p.shape), 1e-9);
        ASSERT_EQ(quad_count(p.mesh), 1);
        const Face f = p.mesh.face(p.mesh.find_halfedge(Vertex(0), Vertex(1)));
        ASSERT_TRUE(p.mesh.is_quad(f));
        EXPECT_EQ(p.mesh.face(p.mesh.find_halfedge(Vertex(2), Vertex(0))), f);
        for (const HalfEdge h : p.mesh.halfedges(f)) {
            const Vertex v = p.mesh.from(h);
            if (v.index() <= 2) continue;
            EXPECT_GT(p.mesh.position(v).x(), p.shape.points[1].x()) << "not beyond the line";
        }
        expect_covered(p.mesh, {0, 1, 3, 5, 7, 9, 11});
        expect_covered(p.mesh, {0, 2, 4, 6, 8, 10, 12});
    }
}

TEST(SharpCorner, OtherCornersAreLeftToTheFront) {
    Prepared wide(wedge(6, 60.0));
    EXPECT_EQ(fill_sharp_corners(wide.mesh), 0);
    Prepared square(shapes::grid(4, 4));
    EXPECT_EQ(fill_sharp_corners(square.mesh), 0);
    Prepared uneven(wedge(6, 25.0, 3.0));  // the corner's edges differ too much to belong together
    EXPECT_EQ(fill_sharp_corners(uneven.mesh), 0);
    Prepared alone(wedge(1, 25.0));  // a loop of three edges
    EXPECT_EQ(fill_sharp_corners(alone.mesh), 0);
    EXPECT_EQ(quad_count(wide.mesh) + quad_count(square.mesh) + quad_count(uneven.mesh) + quad_count(alone.mesh), 0);
}

}  // namespace
}  // namespace anisoquad
