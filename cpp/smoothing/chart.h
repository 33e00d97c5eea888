#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
            is_on_fold_ = true;
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

    /// Axes in the chart for a search round the node, the second of them shorter than 1 by as much as the star is narrower than
    /// long: a step that suits its length would leave it sideways. Stars that are hardly narrower, or folded, have no such axes.
    Eigen::Matrix2d search_axes(const SurfaceMesh& mesh, Vertex v) const {
        if (is_on_fold_) return Eigen::Matrix2d::Identity();
        Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
        const auto add = [&](const Eigen::Vector2d& x) { moment += x * x.transpose(); };
        if (fitted_) {
            for (int i = 0; i < fit_.size(); ++i) add(fit_.parameters(i));
        } else {
            for (const HalfEdge h : mesh.outgoing(v)) {
                const Eigen::Vector3d edge = mesh.position(mesh.to(h)) - centre_;
                add({edge.dot(first_), edge.dot(second_)});
            }
        }
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
        solver.computeDirect(moment);
        const double narrowness = std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / solver.eigenvalues()[1]);
        if (!(narrowness < kNarrow)) return Eigen::Matrix2d::Identity();
        Eigen::Matrix2d axes;
        axes << solver.eigenvectors().col(1), std::max(narrowness, kNarrowest) * solver.eigenvectors().col(0);
        return axes;
    }

  private:
    static constexpr double kNarrow = 0.6;
    static constexpr double kNarrowest = 1e-4;

    SurfaceFit fit_;
    bool fitted_ = false;
    bool is_on_fold_ = false;
    Point centre_;
    Eigen::Vector3d first_;
    Eigen::Vector3d second_;
};

}  // namespace anisoquad
