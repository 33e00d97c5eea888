#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace anisoquad {

/// Scores closer than this are equal, and the first one wins: rounding must not choose between mirror images.
inline constexpr double kTie = 1e-10;
/// Far more than a search near its start needs; what leads farther away is given up.
inline constexpr std::size_t kMostTurns = 128;

/// Looks for the largest score(x) near x in four directions. After every step the directions turn by π/8, so that the search
/// does not stick to a ridge, as the minimum of several measures has them; the step is halved when none is better. (Eight
/// directions at a time gave the same quality in twice the time.) Deterministic.
/// @param score callable, Eigen::Vector2d → double
/// @returns the best score; x is where it was found
template <class Score>
double pattern_search(const Score& score, Eigen::Vector2d& x, double step, double smallest_step) {
    static const std::array<Eigen::Vector2d, 16> kDirections = [] {
        std::array<Eigen::Vector2d, 16> d;
        for (std::size_t i = 0; i < 16; ++i) {
            const double angle = 0.39269908169872414 * static_cast<double>(i);  // π/8
            d[i] = {std::cos(angle), std::sin(angle)};
        }
        return d;
    }();
    double best = score(x);
    for (std::size_t turn = 0; step >= smallest_step && turn < kMostTurns; ++turn) {
        Eigen::Vector2d found = x;
        for (std::size_t i = turn % 4; i < 16; i += 4) {
            const Eigen::Vector2d trial = x + step * kDirections[i];
            const double s = score(trial);
            if (s > best + kTie * std::max(1.0, std::abs(best))) {
                best = s;
                found = trial;
            }
        }
        if (found == x) step *= 0.5;
        x = found;
    }
    return best;
}

}  // namespace anisoquad
