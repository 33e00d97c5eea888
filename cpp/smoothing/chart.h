#pragma once

#include <Eigen/Geometry>

#include "smoothing/star.h"
#include "surface/surface_fit.h"

namespace anisoquad {

/// Coordinates on the surface round a node, for searches: those of the fitted polynomial, or of the tangent plane where there
/// is no fit or the star is folded, so that its exponential map is no map of the surface; on a fold only the way along it counts.
/// The node is at (0,0); coordinates are lengths.
class Chart {
  public:
    Chart(const SurfaceMesh& mesh, Vertex v, const Star& star) : centre_(star.centre()) {
        fitted_ = !star.is_flat() && star.quality(star.centre()).worst > 0.0 && fit_surface(mesh, v, fit_);
        first_ = star.normal().unitOrthogonal();
        second_ = star.normal().cross(first_);
        if (star.is_on_fold()) {
            fitted_ = false;
            first_ = star.along_fold(first_);
            second_ = star.along_fold(second_);
        }
    }
    Point operator()(const Eigen::Vector2d& x) const {
        if (!fitted_) return centre_ + x.x() * first_ + x.y() * second_;
        const Eigen::Vector2d uv = fit_.clamped(x);
        return fit_(uv.x(), uv.y());
    }

  private:
    SurfaceFit fit_;
    bool fitted_ = false;
    Point centre_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

}  // namespace anisoquad
