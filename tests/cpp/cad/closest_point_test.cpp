#include "cad/closest_point.h"

#include <gtest/gtest.h>

#include <random>

#include "cad_shapes.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(ClosestOnFace, IsOnASphereInThePointsDirection) {
    const CadShape sphere = shapes::sphere(2.0);
    std::mt19937 random(1);
    std::normal_distribution<double> coordinate;
    for (int i = 0; i < 200; ++i) {
        const Vector3d p(coordinate(random), coordinate(random), coordinate(random));
        const FacePoint found = closest_on_face(sphere.face(0), p);
        EXPECT_TRUE(found.converged);
        EXPECT_LT((found.position - 2.0 * p.normalized()).norm(), 1e-9) << p.transpose();
        EXPECT_NEAR(found.distance, std::abs(p.norm() - 2.0), 1e-9);
        EXPECT_LT((face_normal(sphere.face(0), found.parameter) - p.normalized()).norm(), 1e-8);
    }
}

TEST(ClosestOnFace, AStartNearByFindsTheSameAsTheSearch) {
    const CadShape wavy = shapes::wavy();
    const CadFace& face = wavy.face(0);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(0.02, 0.98);
    for (int i = 0; i < 200; ++i) {
        Vector2d x;
        for (Eigen::Index k = 0; k < 2; ++k) {
            const Range& r = face.range[static_cast<std::size_t>(k)];
            x[k] = r.low + (r.high - r.low) * share(random);
        }
        gp_Pnt s;
        face.surface->D0(x[0], x[1], s);
        const Vector3d p = Vector3d(s.X(), s.Y(), s.Z()) + 0.02 * face_normal(face, x);
        const FacePoint near = closest_on_face(face, p, x + Vector2d(0.03, -0.02));
        EXPECT_NEAR(near.distance, 0.02, 1e-9);
        EXPECT_LT((near.parameter - x).norm(), 1e-6);
        EXPECT_LT((closest_on_face(face, p).position - near.position).norm(), 1e-8);
    }
}

TEST(ClosestOnFace, StaysInTheFacesRange) {
    const CadShape box = shapes::box();
    for (std::int32_t f = 0; f < 6; ++f) {
        const FacePoint found = closest_on_face(box.face(f), {10.0, 10.0, 10.0});
        EXPECT_LE(found.position.x(), 3.0 + 1e-12);
        EXPECT_LE(found.position.y(), 2.0 + 1e-12);
        EXPECT_LE(found.position.z(), 1.0 + 1e-12);
    }
}

TEST(ClosestOnFace, GoesOnOverTheSeam) {
    const CadShape torus = shapes::torus(3.0, 1.0);
    const Vector3d wanted(4.0 * std::cos(-0.1), 4.0 * std::sin(-0.1), 0.0);
    const FacePoint found = closest_on_face(torus.face(0), 1.05 * wanted, Vector2d(0.1, 0.1));
    EXPECT_LT((found.position - wanted).norm(), 1e-9);
}

TEST(ClosestOnEdge, IsOnACircle) {
    const CadShape cylinder = shapes::cylinder(2.0, 1.0);
    const CadEdge& circle = cylinder.edge(shapes::edge_of_length(cylinder, 4.0 * M_PI));
    for (int i = 0; i < 50; ++i) {
        const double angle = 0.1 + 0.12 * i;
        const Vector3d p(2.3 * std::cos(angle), 2.3 * std::sin(angle), 0.4);
        const Vector3d wanted(2.0 * std::cos(angle), 2.0 * std::sin(angle), cylinder.vertex(circle.vertex[0]).z());
        EXPECT_LT((closest_on_edge(circle, p).position - wanted).norm(), 1e-9);
        EXPECT_LT((closest_on_edge(circle, p, closest_on_edge(circle, p).parameter + 0.2).position - wanted).norm(), 1e-9);
    }
}

TEST(ClosestOnEdge, EndsAtItsEnds) {
    const CadShape box = shapes::box();
    for (const CadEdge& edge : box.edges()) {
        const Vector3d a = box.vertex(edge.vertex[0]);
        const Vector3d b = box.vertex(edge.vertex[1]);
        EXPECT_LT((closest_on_edge(edge, b + (b - a)).position - b).norm(), 1e-12);
        EXPECT_LT((closest_on_edge(edge, 0.5 * (a + b)).position - 0.5 * (a + b)).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace anisoquad::cad
