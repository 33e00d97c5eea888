#include "surface/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace anisoquad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kUnknowns = 5;
/// Smallest pivot over the largest one. The whitened ring has columns of like size, so smaller ones mean that node and ring
/// lie (almost) on one conic and that the second derivatives would be noise.
constexpr double kSmallestPivot = 1e-3;
/// Nodes closer than this to the centre or to a common line, over the ring's extent.
constexpr double kDegenerate = 1e-6;

template <int Rows, int Columns>
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Rows, Columns>;

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Index of the k-th node of an evenly taken subset.
std::size_t taken(std::size_t k, std::size_t all, std::size_t kept) { return k * all / kept; }

}  // namespace

Point SurfaceFit::operator()(double u, double v) const {
    const Vector2d w = whitened(u, v);
    const double s = w.x();
    const double t = w.y();
    const Eigen::Matrix<double, 1, kUnknowns> row(s, t, 0.5 * s * s, s * t, 0.5 * t * t);
    return centre_ + scale_ * (row * coefficients_).transpose();
}

Vector3d SurfaceFit::derivative_u(double u, double v) const {
    const Vector2d w = whitened(u, v);
    const Vector3d by_s = coefficients_.row(0) + w.x() * coefficients_.row(2) + w.y() * coefficients_.row(3);
    const Vector3d by_t = coefficients_.row(1) + w.x() * coefficients_.row(3) + w.y() * coefficients_.row(4);
    return scale_ * (whitening_(0, 0) * by_s + whitening_(1, 0) * by_t);
}

Vector3d SurfaceFit::derivative_v(double u, double v) const {
    const Vector2d w = whitened(u, v);
    const Vector3d by_s = coefficients_.row(0) + w.x() * coefficients_.row(2) + w.y() * coefficients_.row(3);
    const Vector3d by_t = coefficients_.row(1) + w.x() * coefficients_.row(3) + w.y() * coefficients_.row(4);
    return scale_ * (whitening_(0, 1) * by_s + whitening_(1, 1) * by_t);
}

Vector3d SurfaceFit::second_derivative_uu() const {
    const double a = whitening_(0, 0);
    const double b = whitening_(1, 0);
    return scale_ * (a * a * coefficients_.row(2) + 2.0 * a * b * coefficients_.row(3) + b * b * coefficients_.row(4));
}

Vector3d SurfaceFit::second_derivative_uv() const {
    const Matrix2d& w = whitening_;
    return scale_ * (w(0, 0) * w(0, 1) * coefficients_.row(2) + (w(0, 0) * w(1, 1) + w(0, 1) * w(1, 0)) * coefficients_.row(3) +
                     w(1, 0) * w(1, 1) * coefficients_.row(4));
}

Vector3d SurfaceFit::second_derivative_vv() const {
    const double a = whitening_(0, 1);
    const double b = whitening_(1, 1);
    return scale_ * (a * a * coefficients_.row(2) + 2.0 * a * b * coefficients_.row(3) + b * b * coefficients_.row(4));
}

Vector3d SurfaceFit::normal(double u, double v) const { return derivative_u(u, v).cross(derivative_v(u, v)).normalized(); }

Vector2d SurfaceFit::clamped(const Vector2d& uv) const {
    const double distance = whitened(uv.x(), uv.y()).norm();
    return distance > extent_ ? Vector2d(uv * (extent_ / distance)) : uv;
}

/// Exponential map: lengths are kept, angles scaled so that a closed ring has 2π @cite docarmo1976.
bool SurfaceFit::parametrise(std::span<const Point> ring, bool closed) {
    const std::size_t n = ring.size();
    double total_angle = 0.0;
    double total_length = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        total_length += (ring[i] - centre_).norm();
        if (closed || i + 1 < n) total_angle += angle_between(ring[i] - centre_, ring[(i + 1) % n] - centre_);
    }
    scale_ = total_length / static_cast<double>(n);
    if (!(scale_ > 0.0) || !(total_angle > kDegenerate) || !std::isfinite(total_length)) return false;

    const double flat = closed ? 2.0 * std::numbers::pi / total_angle : 1.0;
    const std::size_t kept = std::min(n, static_cast<std::size_t>(kCapacity));
    double angle = 0.0;
    size_ = 0;
    for (std::size_t i = 0; i < n && size_ < static_cast<int>(kept); ++i) {
        if (i == taken(static_cast<std::size_t>(size_), n, kept)) {
            const double length = (ring[i] - centre_).norm();
            if (length < kDegenerate * kDegenerate * scale_) return false;
            ring_[static_cast<std::size_t>(size_++)] = length * Vector2d(std::cos(angle), std::sin(angle));
        }
        angle += flat * angle_between(ring[i] - centre_, ring[(i + 1) % n] - centre_);
    }
    return true;
}

/// Finds the linear map that gives the ring a unit second moment; its inverse square root is closed in two dimensions.
bool SurfaceFit::whiten() {
    Matrix2d moment = Matrix2d::Zero();
    for (int i = 0; i < size_; ++i) moment += parameters(i) * parameters(i).transpose();
    moment *= 2.0 / (static_cast<double>(size_) * scale_ * scale_);
    const double trace = moment.trace();
    const double determinant = moment.determinant();
    if (!(determinant > kDegenerate * kDegenerate * trace * trace)) return false;
    const double s = std::sqrt(determinant);
    const Matrix2d root = (moment + s * Matrix2d::Identity()) / std::sqrt(trace + 2.0 * s);
    whitening_ = root.inverse() / scale_;
    extent_ = 0.0;
    for (int i = 0; i < size_; ++i) extent_ = std::max(extent_, (whitening_ * parameters(i)).norm());
    return true;
}

bool SurfaceFit::solve(std::span<const Point> ring) {
    SmallMatrix<kCapacity, kUnknowns> v(size_, kUnknowns);
    SmallMatrix<kCapacity, 3> nodes(size_, 3);
    for (int i = 0; i < size_; ++i) {
        const Vector2d w = whitening_ * parameters(i);
        v.row(i) << w.x(), w.y(), 0.5 * w.x() * w.x(), w.x() * w.y(), 0.5 * w.y() * w.y();
        const std::size_t k = taken(static_cast<std::size_t>(i), ring.size(), static_cast<std::size_t>(size_));
        nodes.row(i) = ((ring[k] - centre_) / scale_).transpose();
    }
    if (size_ < kUnknowns) {
        // Least norm: F = Vᵀ(VVᵀ)⁻¹N by the factors VᵀP = QR, so that VVᵀ is never formed.
        Eigen::ColPivHouseholderQR<SmallMatrix<kUnknowns, kUnknowns>> qr(kUnknowns, size_);
        qr.setThreshold(kSmallestPivot);
        qr.compute(v.transpose());
        if (qr.rank() < size_) return false;
        SmallMatrix<kUnknowns, 3> y = SmallMatrix<kUnknowns, 3>::Zero(kUnknowns, 3);
        y.topRows(size_) = qr.colsPermutation().transpose() * nodes;
        qr.matrixQR().topLeftCorner(size_, size_).triangularView<Eigen::Upper>().transpose().solveInPlace(y.topRows(size_));
        y.applyOnTheLeft(qr.householderQ());
        coefficients_ = y;
    } else {
        Eigen::ColPivHouseholderQR<SmallMatrix<kCapacity, kUnknowns>> qr(size_, kUnknowns);
        qr.setThreshold(kSmallestPivot);
        qr.compute(v);
        if (qr.rank() < kUnknowns) return false;
        coefficients_ = qr.solve(nodes);
    }
    return coefficients_.allFinite();
}

bool fit_surface(const Point& centre, std::span<const Point> ring, bool closed, SurfaceFit& fit) {
    if (ring.size() < 3) return false;
    fit.centre_ = centre;
    return fit.parametrise(ring, closed) && fit.whiten() && fit.solve(ring);
}

int gather_ring(const SurfaceMesh& mesh, Vertex v, std::span<Point> ring) {
    const HalfEdge first = mesh.halfedge(v);
    if (!first.is_valid() || ring.empty()) return 0;
    const std::size_t all = static_cast<std::size_t>(mesh.valence(v));
    const std::size_t kept = std::min(all, ring.size());
    // The half-edge of a boundary vertex is the one without a face: the last one counter-clockwise.
    HalfEdge h = mesh.is_boundary(first) ? mesh.rotated_ccw(first) : first;
    std::size_t count = 0;
    for (std::size_t i = 0; i < all && count < kept; ++i, h = mesh.rotated_ccw(h)) {
        if (i == taken(count, all, kept)) ring[count++] = mesh.position(mesh.to(h));
    }
    return static_cast<int>(count);
}

bool fit_surface(const SurfaceMesh& mesh, Vertex v, SurfaceFit& fit) {
    std::array<Point, SurfaceFit::kCapacity> ring;
    const int n = gather_ring(mesh, v, ring);
    return fit_surface(mesh.position(v), std::span<const Point>(ring.data(), static_cast<std::size_t>(n)), !mesh.is_boundary(v),
                       fit);
}

Point point_at_target(const SurfaceFit& fit, const Point& target) {
    Vector2d uv = Vector2d::Zero();
    for (int step = 0; step < 3; ++step) {
        Eigen::Matrix<double, 3, 2> jacobian;
        jacobian << fit.derivative_u(uv.x(), uv.y()), fit.derivative_v(uv.x(), uv.y());
        const Matrix2d metric = jacobian.transpose() * jacobian;
        const double determinant = metric.determinant();
        if (!(determinant > kDegenerate * metric.trace() * metric.trace())) break;
        uv = fit.clamped(uv + metric.inverse() * (jacobian.transpose() * (target - fit(uv.x(), uv.y()))));
    }
    return fit(uv.x(), uv.y());
}

}  // namespace anisoquad
