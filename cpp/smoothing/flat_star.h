#pragma once

#include <Eigen/Core>
#include <array>

#include "smoothing/star.h"

namespace anisoquad {

/// A star that hardly turns, drawn in its tangent plane, where the derivatives of what a place of the node is worth are cheap.
class FlatStar {
  public:
    /// @pre star.has_quads_only(); the flatter the star, the better its steps
    explicit FlatStar(const Star& star);

    /// Derivatives of the corners' mean sine less the stretch (Star::Quality) by the node's place, at its old place.
    struct Derivatives {
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    };
    Derivatives derivatives() const;
    /// Point in space. @param x in the plane's coordinates: the node's old place is (0,0)
    Point operator()(const Eigen::Vector2d& x) const { return centre_ + x.x() * first_ + x.y() * second_; }

  private:
    struct Wedge {
        Eigen::Vector2d next;
        Eigen::Vector2d previous;
        Eigen::Vector2d after_next;       ///< unit, from the next node to the opposite one
        Eigen::Vector2d before_previous;  ///< unit, from the opposite node to the previous one
        double shortest2;                 ///< of the two edges that stay as they are
        double longest2;
    };
    std::array<Wedge, Star::kCapacity> wedges_;
    int size_ = 0;
    Point centre_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

}  // namespace anisoquad
