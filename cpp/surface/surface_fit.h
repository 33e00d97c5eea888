#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// The surface round a node as a quadratic polynomial over the exponential map of its one-ring @cite merhof2007 (2.1).
///
///     F(u,v) = N + u F_u + v F_v + u²/2 F_uu + uv F_uv + v²/2 F_vv
///
/// u and v are lengths (in the user's units) along the surface, measured from the centre node N; the u axis points to the
/// first node of the ring. Inside, the polynomial stands over coordinates whose ring has a unit second moment, so that
/// neither the model's size nor stretched rings spoil its condition.
class SurfaceFit {
  public:
    static constexpr int kCapacity = 24;  ///< of larger rings an evenly taken subset is fitted

    Point operator()(double u, double v) const;
    Eigen::Vector3d derivative_u(double u, double v) const;
    Eigen::Vector3d derivative_v(double u, double v) const;
    Eigen::Vector3d second_derivative_uu() const;
    Eigen::Vector3d second_derivative_uv() const;
    Eigen::Vector3d second_derivative_vv() const;
    /// Unit normal, on the side from which the ring runs counter-clockwise; zero where the polynomial is singular.
    Eigen::Vector3d normal(double u, double v) const;

    const Point& centre() const { return centre_; }
    /// Number of ring nodes that were fitted.
    int size() const { return size_; }
    /// (u,v) of a ring node.
    const Eigen::Vector2d& parameters(int i) const { return ring_[static_cast<std::size_t>(i)]; }
    /// Mean distance of the ring's nodes from the centre.
    double scale() const { return scale_; }
    /// (u,v) pulled back into the extent of the ring (an ellipse round a stretched ring).
    Eigen::Vector2d clamped(const Eigen::Vector2d& uv) const;

  private:
    friend bool fit_surface(const Point& centre, std::span<const Point> ring, bool closed, SurfaceFit& fit);
    Eigen::Vector2d whitened(double u, double v) const { return whitening_ * Eigen::Vector2d(u, v); }
    bool parametrise(std::span<const Point> ring, bool closed);
    bool whiten();
    bool solve(std::span<const Point> ring);

    Point centre_ = Point::Zero();
    double scale_ = 1.0;
    double extent_ = 0.0;                                      ///< largest whitened distance of a ring node
    Eigen::Matrix2d whitening_ = Eigen::Matrix2d::Identity();  ///< (s,t) = whitening · (u,v)
    Eigen::Matrix<double, 5, 3> coefficients_ = Eigen::Matrix<double, 5, 3>::Zero();  ///< by s, t, s²/2, st, t²/2; over scale
    std::array<Eigen::Vector2d, kCapacity> ring_;
    int size_ = 0;
};

/// Fits the polynomial to the ring: least norm for fewer than five nodes, exact for five, least squares for more.
/// @param ring nodes joined to the centre by an edge, counter-clockwise
/// @param closed true at an interior node: the angles are scaled to 2π. An open ring keeps its true angles.
/// @returns false when there is no solution or it is ill-conditioned (fewer than three nodes, nodes in one line, two nodes
///          at one place, node and ring on one conic); `fit` is then not to be used
bool fit_surface(const Point& centre, std::span<const Point> ring, bool closed, SurfaceFit& fit);
/// Fits the one-ring of a node of the mesh; its position is the centre.
bool fit_surface(const SurfaceMesh& mesh, Vertex v, SurfaceFit& fit);

/// The one-ring of a node in counter-clockwise order. @returns number of nodes written, at most ring.size(): of larger rings
/// an evenly taken subset
int gather_ring(const SurfaceMesh& mesh, Vertex v, std::span<Point> ring);

/// The point of the fitted surface for a 3D target near the tangent plane: Gauss-Newton from the centre, kept in the ring.
Point point_at_target(const SurfaceFit& fit, const Point& target);

}  // namespace anisoquad
