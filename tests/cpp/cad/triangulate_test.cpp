#include "cad/triangulate.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <set>

#include "cad/check_triangles.h"
#include "cad/closest_point.h"
#include "cad/to_eigen.h"
#include "cad_shapes.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

double volume(const Triangulation& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto p = [&](std::int32_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
        sum += p(a).dot(p(b).cross(p(c))) / 6.0;
    }
    return sum;
}

long euler(const Triangulation& mesh) {
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
    return static_cast<long>(mesh.points.size()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
}

TEST(Triangulate, SolidsBecomeClosedSurfacesWithNormalsOutwards) {
    const struct {
        CadShape shape;
        double volume;
        long euler;
    } cases[] = {{shapes::box(3, 2, 1), 6.0, 2},
                 {shapes::cylinder(1.0, 2.0), 2.0 * M_PI, 2},
                 {shapes::sphere(1.0), 4.0 / 3.0 * M_PI, 2},
                 {shapes::torus(3.0, 1.0), 6.0 * M_PI * M_PI, 0},
                 {shapes::cone(), 2.0 / 3.0 * M_PI, 2},
                 {shapes::stadium(), 8.0 + M_PI, 2}};
    for (const auto& c : cases) {
        const Triangulation mesh = triangulate(c.shape);
        EXPECT_NO_THROW(check_triangles(mesh.points, mesh.triangles)) << c.shape.name();
        EXPECT_NEAR(volume(mesh), c.volume, 0.01 * c.volume) << c.shape.name();
        EXPECT_EQ(euler(mesh), c.euler) << c.shape.name();
    }
}

TEST(Triangulate, IsFinerWhereAsked) {
    const CadShape torus = shapes::torus();
    const std::size_t coarse = triangulate(torus, {0.05, 30.0}).triangles.size();
    EXPECT_GT(triangulate(torus, {0.005, 30.0}).triangles.size(), 2 * coarse);
    EXPECT_GT(triangulate(torus, {0.05, 5.0}).triangles.size(), 2 * coarse);
    EXPECT_EQ(triangulate(torus, {0.05, 30.0}).triangles.size(), coarse) << "what was made before is not taken again";
}

TEST(Triangulate, KnowsTheFaceOfEveryTriangleAndTheNodesOnEveryEdge) {
    for (const CadShape& shape :
         {shapes::box(), shapes::cylinder(), shapes::sphere(), shapes::cone(), shapes::torus(), shapes::loose_box()}) {
        const Triangulation mesh = triangulate(shape);
        ASSERT_EQ(mesh.origin.facet_face.size(), mesh.triangles.size());
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            for (const std::int32_t v : mesh.triangles[f]) {
                const FacePoint on =
                    closest_on_face(shape.face(mesh.origin.facet_face[f]), mesh.points[static_cast<std::size_t>(v)]);
                EXPECT_LT(on.distance, 1e-7) << shape.name();
            }
        }
        ASSERT_EQ(mesh.origin.paths.size(), shape.edges().size());
        const Neighbours neighbours(mesh.points.size(), mesh.triangles);
        for (std::size_t e = 0; e < shape.edges().size(); ++e) {
            const EdgePath& path = mesh.origin.paths[e];
            if (shape.edges()[e].is_degenerated()) continue;
            ASSERT_GE(path.vertices.size(), 2u) << shape.name();
            EXPECT_TRUE(std::is_sorted(path.parameters.begin(), path.parameters.end())) << shape.name();
            for (std::size_t i = 0; i < path.vertices.size(); ++i) {
                const gp_Pnt on = shape.edges()[e].curve->Value(path.parameters[i]);
                EXPECT_LT((mesh.points[static_cast<std::size_t>(path.vertices[i])] - to_eigen(on)).norm(), 1e-7) << shape.name();
                if (i == 0) continue;
                EXPECT_TRUE(std::ranges::binary_search(neighbours.of(path.vertices[i - 1]), path.vertices[i])) << shape.name();
            }
        }
    }
}

TEST(Triangulate, FacesThatAreNotSewnAreJoined) {
    const Triangulation mesh = triangulate(shapes::loose_box());
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_EQ(euler(mesh), 2);
}

TEST(Triangulate, IsKnownAgainInSinglePrecisionAndNotWhereAPointWasMoved) {
    const CadShape torus = shapes::torus();
    const Triangulation mesh = triangulate(torus);
    std::vector<Eigen::Vector3d> points = mesh.points;
    for (Eigen::Vector3d& p : points) p = p.cast<float>().cast<double>();
    EXPECT_TRUE(is_same(mesh, points, mesh.triangles, torus.diagonal()));
    points[5].x() += 1e-3;
    EXPECT_FALSE(is_same(mesh, points, mesh.triangles, torus.diagonal()));
    points.pop_back();
    EXPECT_FALSE(is_same(mesh, points, mesh.triangles, torus.diagonal()));
}

TEST(Triangulate, RejectsBadOptions) {
    const CadShape box = shapes::box();
    EXPECT_THROW(triangulate(box, {-1.0, 10.0}), Error);
    EXPECT_THROW(triangulate(box, {0.1, 0.0}), Error);
}

}  // namespace
}  // namespace anisoquad::cad
