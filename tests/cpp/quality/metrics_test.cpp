#include "quality/metrics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/euler_operators.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using Nodes = std::array<Point, 4>;

/// Values of vtkMeshQuality 9.1. Its warpage is the cube of the cosine of ours.
struct Reference {
    Nodes nodes;
    double scaled_jacobian, edge_ratio, min_angle, max_angle, skew, warpage;
};

const std::vector<Reference>& references() {
    static const std::vector<Reference> all{
        {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, 1, 1, 90, 90, 0, 1},
        {{{{0, 0, 0}, {4, 0, 0}, {4, 0.5, 0}, {0, 0.5, 0}}}, 1, 8, 90, 90, 0, 1},
        {{{{0, 0, 0}, {2, 0.3, 0}, {2.5, 1.4, 0}, {-0.2, 1, 0}}},
         0.838910787813921,
         2.67646437272412,
         57.1290761981028,
         122.974720390365,
         0.285709224300354,
         1},
        {{{{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}}},
         0.91743119266055,
         1,
         85.2637637543281,
         85.2637637543281,
         0,
         0.335579587007435},
        {{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.3, 0}, {0, 1, 0}}},  // an arrow
         -0.689655172413793,
         1.31306432859723,
         23.1985905136482,
         223.602818972704,
         0.834862385321101,
         -1},
        {{{{0, 0, 0}, {2, 1, 0.1}, {0, 1, 0.4}, {1.5, 0, -0.2}}},  // a bow tie
         -0.565142589404455,
         1.47911220864551,
         28.3828024405825,
         325.51599264349,
         0.162142423599352,
         -0.99965297791019},
        {{{{1, 2, 3}, {4, 2, 3.5}, {4.5, 2.2, 6}, {0.5, 1.7, 5}}},
         0.89797485364211,
         1.99365352503392,
         64.3364178511061,
         110.70570597924,
         0.207420400107832,
         0.906944215603242},
    };
    return all;
}

TEST(Metrics, AgreeWithVerdict) {
    for (const Reference& r : references()) {
        const auto& [a, b, c, d] = r.nodes;
        EXPECT_NEAR(scaled_jacobian(a, b, c, d), r.scaled_jacobian, 1e-12);
        EXPECT_NEAR(aspect_ratio(a, b, c, d), r.edge_ratio, 1e-12);
        EXPECT_NEAR(min_angle(a, b, c, d), r.min_angle, 1e-10);
        EXPECT_NEAR(max_angle(a, b, c, d), r.max_angle, 1e-10);
        EXPECT_NEAR(skew(a, b, c, d), r.skew, 1e-12);
        EXPECT_NEAR(std::pow(std::cos(warpage(a, b, c, d) * std::numbers::pi / 180.0), 3.0), r.warpage, 1e-12);
    }
}

TEST(Metrics, DoNotDependOnSizePositionAndFirstNode) {
    for (const Reference& r : references()) {
        for (const double scale : {1e-9, 1e9}) {
            for (std::size_t k = 0; k < 4; ++k) {
                Nodes q;
                for (std::size_t i = 0; i < 4; ++i) q[i] = scale * (r.nodes[(i + k) % 4] + Point(30, -20, 10));
                const auto& [a, b, c, d] = q;
                EXPECT_NEAR(scaled_jacobian(a, b, c, d), r.scaled_jacobian, 1e-12);
                EXPECT_NEAR(aspect_ratio(a, b, c, d), r.edge_ratio, 1e-12);
                EXPECT_NEAR(min_angle(a, b, c, d), r.min_angle, 1e-9);
                EXPECT_NEAR(max_angle(a, b, c, d), r.max_angle, 1e-9);
                EXPECT_NEAR(skew(a, b, c, d), r.skew, 1e-12);
                EXPECT_NEAR(area(a, b, c, d) / (scale * scale), area(r.nodes[0], r.nodes[1], r.nodes[2], r.nodes[3]), 1e-12);
            }
        }
    }
}

TEST(Metrics, ZeroEdgesAreTheWorst) {
    const Point a(0, 0, 0);
    const Point b(1, 0, 0);
    const Point c(1, 1, 0);
    EXPECT_EQ(scaled_jacobian(a, b, c, a), 0.0);
    EXPECT_EQ(scaled_jacobian(a, b, c, a, {0, 0, 1}), 0.0);
    EXPECT_EQ(aspect_ratio(a, b, c, a), std::numeric_limits<double>::infinity());
    EXPECT_EQ(min_angle(a, b, c, a), 0.0);
    EXPECT_EQ(max_angle(a, b, c, a), 360.0);
    EXPECT_TRUE(std::isfinite(skew(a, a, a, a)));
    EXPECT_EQ(area(a, a, a, a), 0.0);
}

TEST(Metrics, AGivenNormalTellsAQuadThatIsTurnedOver) {
    const Nodes q{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)};
    EXPECT_NEAR(scaled_jacobian(q[0], q[1], q[2], q[3], {0, 0, 5}), 1.0, 1e-15);
    EXPECT_NEAR(scaled_jacobian(q[3], q[2], q[1], q[0], {0, 0, 5}), -1.0, 1e-15);
    EXPECT_NEAR(scaled_jacobian(q[3], q[2], q[1], q[0]), 1.0, 1e-15);
}

TEST(Metrics, OfAFaceAreThoseOfItsNodes) {
    SurfaceMesh mesh = shapes::grid(1, 1, 2.0, 0.5).mesh();
    const HalfEdge h = mesh.find_halfedge(Vertex(0), Vertex(3));
    const Face f = dissolve_edge(mesh, SurfaceMesh::edge(h));
    EXPECT_NEAR(scaled_jacobian(mesh, f), 1.0, 1e-15);
    EXPECT_NEAR(scaled_jacobian(mesh, f, {0, 0, -1}), -1.0, 1e-15);
    EXPECT_NEAR(aspect_ratio(mesh, f), 4.0, 1e-15);
    EXPECT_NEAR(min_angle(mesh, f), 90.0, 1e-12);
    EXPECT_NEAR(max_angle(mesh, f), 90.0, 1e-12);
    EXPECT_NEAR(skew(mesh, f), 0.0, 1e-15);
    EXPECT_NEAR(warpage(mesh, f), 0.0, 1e-12);
    EXPECT_NEAR(area(mesh, f), 1.0, 1e-15);
}

}  // namespace
}  // namespace anisoquad
