#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "smoothing/pattern_search.h"

namespace anisoquad {

/// Way to the maximum of the quadratic model with these derivatives, times `relaxation`; uphill where the model has none.
/// @param most longest step
inline Eigen::Vector2d newton_step(const Eigen::Vector2d& gradient, const Eigen::Matrix2d& hessian, double relaxation,
                                   double most) {
    const double determinant = hessian.determinant();
    const bool has_maximum = hessian(0, 0) < 0.0 && determinant > 0.0;
    const Eigen::Vector2d step = has_maximum ? Eigen::Vector2d(relaxation * (hessian.inverse() * -gradient)) : gradient;
    const double length = step.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return Eigen::Vector2d::Zero();
    return has_maximum && length <= most ? step : Eigen::Vector2d(step * (most / length));
}

/// One Newton step towards the largest score(x) near (0,0), with derivatives from differences over `span`. Whatever of all places
/// tried is best is taken, so that the kinks of measures which are minima do no harm. Seven scores. Deterministic.
/// @param score callable, Eigen::Vector2d → double
template <class Score>
Eigen::Vector2d newton_search(const Score& score, double span, double relaxation, double most) {
    Eigen::Vector2d best_place = Eigen::Vector2d::Zero();
    const double here = score(best_place);
    double best = here;
    const auto attempt = [&](const Eigen::Vector2d& x) {
        const double s = score(x);
        if (s > best + kTie * std::max(1.0, std::abs(best))) {
            best = s;
            best_place = x;
        }
        return s;
    };
    const double right = attempt({span, 0.0});
    const double left = attempt({-span, 0.0});
    const double above = attempt({0.0, span});
    const double below = attempt({0.0, -span});
    const double corner = attempt({span, span});
    const Eigen::Vector2d gradient((right - left) / (2.0 * span), (above - below) / (2.0 * span));
    Eigen::Matrix2d hessian;
    hessian << right + left - 2.0 * here, corner - right - above + here, corner - right - above + here,
        above + below - 2.0 * here;
    attempt(newton_step(gradient, hessian / (span * span), relaxation, most));
    return best_place;
}

}  // namespace anisoquad
