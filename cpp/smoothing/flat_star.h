#pragma once

#include <Eigen/Core>
#include <array>

#include "smoothing/star.h"

namespace anisoquad {

/// A star that hardly turns, drawn in its tangent plane: what a search for the node's place evaluates, at a fraction of the cost. What
/// does not depend on the node's place is computed once.
class FlatStar {
  public:
    /// @pre star.is_flat() and star.has_quads_only()
    explicit FlatStar(const Star& star);

    /// Star::Quality::score() with the node at x, in the plane's coordinates: the node's old place is (0,0).
    double score(const Eigen::Vector2d& x) const;
    /// Point in space. @param x in the plane's coordinates
    Point at(const Eigen::Vector2d& x) const { return centre_ + x.x() * first_ + x.y() * second_; }

  private:
    struct Wedge {
        Eigen::Vector2d next;
        Eigen::Vector2d previous;
        Eigen::Vector2d after_next;       ///< unit, from the next node to the opposite one
        Eigen::Vector2d before_previous;  ///< unit, from the opposite node to the previous one
        double opposite_sine;
        double shortest2;  ///< of the two edges that stay as they are
        double longest2;
    };
    std::array<Wedge, Star::kCapacity> wedges_;
    int size_ = 0;
    Point centre_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

}  // namespace anisoquad
