#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

namespace anisoquad {

/// Where a node is on the input's triangles: from there a TargetSurface knows what the node lies on, and where to look.
struct TargetPlace {
    std::int32_t facet = -1;                            ///< input triangle near the node, in the node's patch
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< barycentric, of the point of that triangle
    std::array<std::int32_t, 2> edge{-1, -1};           ///< of a node on a feature line: vertices of the input's edge near it
    double share = 0.0;                                 ///< how far from the first to the second, 0…1
};

/// The surface behind the input's triangles, as a CAD shape, to which nodes are brought. The core knows it only by this.
class TargetSurface {
  public:
    virtual ~TargetSurface() = default;
    /// Moves each point to the closest one of what its place lies on: the curve behind the edge where there is one, else the
    /// surface behind the facet. Points and places are in the input's coordinates, equally many. Safe to call from several
    /// threads; what becomes of a point depends on nothing but it and its place.
    virtual void project(std::span<const TargetPlace> places, std::span<Eigen::Vector3d> points) const = 0;
};

/// A target as seen from the mesh's frame, in which the model lies at the origin and has the size 1.
class FramedTarget {
  public:
    FramedTarget() = default;
    /// @param target null: there is none. Input coordinates are centre + scale · mesh coordinates.
    FramedTarget(const TargetSurface* target, const Eigen::Vector3d& centre, double scale)
        : target_(target), centre_(centre), scale_(scale) {}

    explicit operator bool() const { return target_ != nullptr; }
    /// As TargetSurface::project, in mesh coordinates. @pre there is a target
    void project(std::span<const TargetPlace> places, std::span<Eigen::Vector3d> points) const {
        for (Eigen::Vector3d& p : points) p = centre_ + scale_ * p;
        target_->project(places, points);
        for (Eigen::Vector3d& p : points) p = (p - centre_) / scale_;
    }

  private:
    const TargetSurface* target_ = nullptr;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    double scale_ = 1.0;
};

}  // namespace anisoquad
