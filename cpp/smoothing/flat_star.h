#pragma once

#include <Eigen/Core>
#include <array>

#include "smoothing/star.h"

namespace anisoquad {

/// A star that hardly turns, drawn in its tangent plane, where the quality of its faces and the derivatives of what a place of
/// the node is worth are cheap.
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
    /// Quality of the faces with the node at x, as in the plane. See Star::quality(). @param x the node's old place is (0,0)
    Star::Quality quality(const Eigen::Vector2d& x) const;
    /// Point in space. @param x in the plane's coordinates
    Point operator()(const Eigen::Vector2d& x) const { return centre_ + x.x() * first_ + x.y() * second_; }
    /// The point's coordinates in the plane.
    Eigen::Vector2d coordinates(const Point& p) const { return {(p - centre_).dot(first_), (p - centre_).dot(second_)}; }

  private:
    struct Wedge {
        Eigen::Vector2d next;
        Eigen::Vector2d opposite;
        Eigen::Vector2d previous;
        Eigen::Vector2d after_next;       ///< unit, from the next node to the opposite one
        Eigen::Vector2d before_previous;  ///< unit, from the opposite node to the previous one
        double at_opposite;               ///< sine of the corner that stays as it is
        double shortest2;                 ///< of the two edges that stay as they are
        double longest2;
    };
    static Star::FaceQuality quality(const Wedge& w, const Eigen::Vector2d& x);

    std::array<Wedge, Star::kCapacity> wedges_;
    int size_ = 0;
    Point centre_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

}  // namespace anisoquad
