#include "cad/triangulate.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <set>

#include "cad/check_triangles.h"
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

TEST(Triangulate, RejectsBadOptions) {
    const CadShape box = shapes::box();
    EXPECT_THROW(triangulate(box, {-1.0, 10.0}), Error);
    EXPECT_THROW(triangulate(box, {0.1, 0.0}), Error);
}

}  // namespace
}  // namespace anisoquad::cad
