#include "smoothing/newton_step.h"

#include <gtest/gtest.h>

namespace anisoquad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// A hill with its top at (0.3, −0.2) and axes askew.
double hill(const Vector2d& x) {
    const Vector2d d = x - Vector2d(0.3, -0.2);
    return 5.0 - 2.0 * d.x() * d.x() - d.y() * d.y() - 1.5 * d.x() * d.y();
}

TEST(NewtonStep, LeadsToTheTopOfAQuadraticHill) {
    const Vector2d gradient = Vector2d(4.0 * 0.3 - 1.5 * 0.2, -2.0 * 0.2 + 1.5 * 0.3);
    const Matrix2d hessian{{-4.0, -1.5}, {-1.5, -2.0}};
    EXPECT_LT((newton_step(gradient, hessian, 1.0, 1.0) - Vector2d(0.3, -0.2)).norm(), 1e-12);
    EXPECT_LT((newton_step(gradient, hessian, 1.6, 1.0) - 1.6 * Vector2d(0.3, -0.2)).norm(), 1e-12);
    EXPECT_NEAR(newton_step(gradient, hessian, 1.6, 0.1).norm(), 0.1, 1e-12);
}

TEST(NewtonStep, GoesUphillWhereTheModelHasNoTop) {
    for (const Matrix2d& hessian :
         {Matrix2d{{1.0, 0.0}, {0.0, -1.0}}, Matrix2d{{1.0, 0.0}, {0.0, 1.0}}, Matrix2d{{-1.0, 2.0}, {2.0, -1.0}}}) {
        EXPECT_LT((newton_step(Vector2d(3.0, 4.0), hessian, 1.6, 0.5) - Vector2d(0.3, 0.4)).norm(), 1e-12);
        EXPECT_EQ(newton_step(Vector2d::Zero(), hessian, 1.6, 0.5), Vector2d(Vector2d::Zero()));
    }
}

TEST(NewtonSearch, FindsTheTopByDifferences) {
    EXPECT_LT((newton_search(hill, 0.01, 1.0, 1.0) - Vector2d(0.3, -0.2)).norm(), 1e-9);
}

TEST(NewtonSearch, NeverEndsLowerThanItBegan) {
    const auto kinked = [](const Vector2d& p) { return std::min(p.x() + 0.1 * p.y(), -2.0 * p.x() + 0.3 * p.y()); };
    const Vector2d x = newton_search(kinked, 0.01, 1.6, 0.2);
    EXPECT_GT(kinked(x), 0.0);
    const auto top = [](const Vector2d& p) { return -p.lpNorm<1>(); };
    EXPECT_EQ(newton_search(top, 0.01, 1.6, 0.2), Vector2d(Vector2d::Zero()));
}

}  // namespace
}  // namespace anisoquad
