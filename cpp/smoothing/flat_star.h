#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "mesh/surface_mesh.h"
#include "smoothing/star.h"

namespace anisoquad {

/// A star that hardly turns, drawn in its tangent plane, where the quality of its faces and the derivatives of what a place of
/// the node is worth are cheap. Most stars of a mesh are such ones.
class FlatStar {
  public:
    /// @returns false if the star is not flat (Star::is_flat()), has no area or more than Star::kCapacity faces
    /// @pre v is not on the boundary
    bool gather(const SurfaceMesh& mesh, Vertex v);

    /// The node's place when the star was gathered: (0,0) in the plane.
    const Point& centre() const { return centre_; }
    /// Unit normal of the plane.
    const Eigen::Vector3d& normal() const { return normal_; }
    /// Mean length of the node's edges.
    double edge_length() const { return edge_length_; }
    std::int32_t patch() const { return patch_; }
    bool has_quads_only() const { return has_quads_only_; }
    /// See Star::stays_near(): of a flat star this is always so.
    static bool stays_near(const ReferenceSurface& /*reference*/, const Point& /*p*/) { return true; }

    /// The quality of the faces with the node at its old place, and there the derivatives by it of the corners' mean sine less
    /// the stretch (Star::Quality).
    struct Expansion {
        Star::Quality quality;
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    };
    /// @pre has_quads_only()
    Expansion expand() const;
    /// Quality of the faces with the node at x, as in the plane. See Star::quality().
    Star::Quality quality(const Eigen::Vector2d& x) const;
    /// The same with the node at a point in space, seen along the normal.
    Star::Quality quality(const Point& p) const { return quality(coordinates(p)); }
    /// Point in space. @param x in the plane's coordinates
    Point operator()(const Eigen::Vector2d& x) const { return centre_ + x.x() * first_ + x.y() * second_; }
    /// The point's coordinates in the plane.
    Eigen::Vector2d coordinates(const Point& p) const { return drawn(p - centre_); }

  private:
    struct Wedge {
        Eigen::Vector2d next;
        Eigen::Vector2d previous;
        double length;  ///< of the edge to the next node, the node being at (0,0)
        bool quad;
        // Quads only.
        Eigen::Vector2d opposite;
        Eigen::Vector2d after_next;       ///< unit, from the next node to the opposite one
        Eigen::Vector2d before_previous;  ///< unit, from the opposite node to the previous one
        double at_opposite;               ///< sine of the corner that stays as it is
        // Of the edges that stay as they are: two of a quad, one of a triangle.
        double shortest2;
        double longest2;
    };
    static Star::FaceQuality quality(const Wedge& w, const Eigen::Vector2d& x);
    Eigen::Vector2d drawn(const Eigen::Vector3d& way) const { return {way.dot(first_), way.dot(second_)}; }

    std::array<Wedge, Star::kCapacity> wedges_;
    int size_ = 0;
    Point centre_;
    Eigen::Vector3d normal_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
    double edge_length_ = 0.0;
    std::int32_t patch_ = -1;
    bool has_quads_only_ = false;
};

}  // namespace anisoquad
