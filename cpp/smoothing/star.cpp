#include "smoothing/star.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace anisoquad {
namespace {

using Eigen::Vector3d;

/// Corner areas below this, over the squared mean edge length, count as (almost) inverted when a star is untangled.
constexpr double kLeastCornerArea = 0.1;
/// Cosine between a face and the normal of its star below which the star counts as curved.
constexpr double kFlat = 0.7;
/// The same, below which faces can leave the surface by more than a little.
constexpr double kStraight = 0.9;
/// Smallest mean square of the normals' part along any direction where the surface is a tip rather than a fold.
constexpr double kTip = 0.15;
/// Least cosine between a face of a curved star and the surface's normal.
constexpr double kUpright = 0.25;
/// Distance of faces and edges from the surface, over its diagonal, that is allowed in any case.
constexpr double kNear = 5e-4;

}  // namespace

bool Star::gather(const SurfaceMesh& mesh, Vertex v) {
    size_ = 0;
    centre_ = mesh.position(v);
    normal_.setZero();
    edge_length_ = 0.0;
    patch_ = -1;
    hint_ = -1;
    int edges = 0;
    std::array<Vector3d, kCapacity> area;
    for (HalfEdge h : mesh.outgoing(v)) {
        edge_length_ += mesh.length(h);
        ++edges;
        const Face f = mesh.face(h);
        if (!f.is_valid()) continue;
        if (size_ == kCapacity) return false;
        const auto i = static_cast<std::size_t>(size_++);
        Wedge& w = wedges_[i];
        const HalfEdge after = mesh.next(h);
        w.next = mesh.position(mesh.to(h));
        w.opposite = mesh.position(mesh.to(after));
        w.previous = mesh.position(mesh.from(mesh.prev(h)));
        w.quad = mesh.next(after) != mesh.prev(h);
        if (w.quad) {
            w.after_next = w.opposite - w.next;
            w.before_previous = w.previous - w.opposite;
            w.across = w.previous - w.next;
            w.opposite_area = w.after_next.cross(w.before_previous);
            w.after_next_length = w.after_next.norm();
            w.before_previous_length = w.before_previous.norm();
        }
        area[i] = area_vector(w);
        normal_ += area[i];
        patch_ = std::max(patch_, mesh.info(f).patch);
    }
    if (size_ == 0 || !(edge_length_ > 0.0)) return false;
    edge_length_ /= edges;
    normal_ /= edge_length_ * edge_length_;
    const double length = normal_.norm();
    if (!(length > 0.0)) return false;
    normal_ /= length;
    see_along(normal_);
    least_cosine_ = 1.0;
    upright_ = 0.0;
    is_on_fold_ = false;
    distance_before_.reset();
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
        const double size = area[i].norm();
        if (size > 0.0) least_cosine_ = std::min(least_cosine_, area[i].dot(normal_) / size);
    }
    return true;
}

void Star::see_along_surface(const ReferenceSurface& reference, std::int32_t hint) {
    hint_ = hint;
    if (least_cosine_ >= kFlat) return;
    upright_ = kUpright;
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[static_cast<std::size_t>(i)];
        const SurfacePoint closest = reference.closest(middle(w, centre_), patch_, hint);
        hint = closest.facet;
        if (hint >= 0) w.up = closest.normal;
    }
    if (quality(centre_).worst > 0.0) find_fold();
}

Point Star::middle(const Wedge& w, const Point& p) const {
    return w.quad ? Point(0.25 * (p + w.next + w.opposite + w.previous)) : Point((p + w.next + w.previous) / 3.0);
}

template <class Visit>
bool Star::for_middles(const ReferenceSurface& reference, const Point& p, double enough, const Visit& visit) const {
    std::int32_t hint = hint_;
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        if (!visit(reference.distance(middle(w, p), patch_, enough, hint))) return false;
        std::int32_t of_edge = hint;
        if (!visit(reference.distance(0.5 * (p + w.next), patch_, enough, of_edge))) return false;
    }
    return true;
}

bool Star::is_within(const ReferenceSurface& reference, const Point& p, double most) const {
    return for_middles(reference, p, most, [most](double distance) { return distance <= most; });
}

bool Star::stays_near(const ReferenceSurface& reference, const Point& p) {
    if (least_cosine_ >= kStraight) return true;
    const double near = kNear * reference.diagonal();
    if (is_within(reference, p, near)) return true;
    if (!distance_before_) {
        distance_before_ = 0.0;
        for_middles(reference, centre_, near, [this](double distance) {
            distance_before_ = std::max(*distance_before_, distance);
            return true;
        });
    }
    return *distance_before_ > near && is_within(reference, p, *distance_before_);
}

/// The direction in which all faces lie: the eigenvector of the normals' covariance with the smallest eigenvalue.
void Star::find_fold() {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int i = 0; i < size_; ++i) {
        const Vector3d n = area_vector(wedges_[static_cast<std::size_t>(i)]).stableNormalized();
        covariance += n * n.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(covariance / size_);
    is_on_fold_ = true;
    const bool is_tip = solver.eigenvalues()[0] > kTip;
    fold_axis_ = is_tip ? Vector3d(Vector3d::Zero()) : Vector3d(solver.eigenvectors().col(0));
}

void Star::see_along(const Vector3d& normal) {
    for (int i = 0; i < size_; ++i) wedges_[static_cast<std::size_t>(i)].up = normal;
}

void Star::use_face_normals() {
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[static_cast<std::size_t>(i)];
        w.up = area_vector(w).normalized();
    }
}

/// Twice the area vector of the face with the node where it was.
Vector3d Star::area_vector(const Wedge& w) const {
    return w.quad ? (w.opposite - centre_).cross(w.previous - w.next).eval()
                  : (w.next - centre_).cross(w.previous - centre_).eval();
}

Star::FaceQuality Star::quality(const Wedge& wedge, const Point& p) const {
    const Vector3d first = wedge.next - p;
    const Vector3d last = p - wedge.previous;
    if (!wedge.quad) {
        const Vector3d area = first.cross(wedge.previous - p);
        const double sum = first.squaredNorm() + last.squaredNorm() + (wedge.previous - wedge.next).squaredNorm();
        const double shape = triangle_shape(area.norm(), sum);
        const double quality = area.dot(wedge.up) > upright_ * area.norm() ? shape : -shape;
        return {quality, quality, quality, 1.0};
    }
    const double first_length = first.norm();
    const double last_length = last.norm();
    const double shortest = std::min({first_length, wedge.after_next_length, wedge.before_previous_length, last_length});
    if (!(shortest > 0.0)) return {};
    const double longest = std::max({first_length, wedge.after_next_length, wedge.before_previous_length, last_length});
    const Vector3d axes = (wedge.opposite - p).cross(wedge.across);
    const double length = axes.norm();
    // A quad that is turned over is good by its own normal; seen along the surface's it is not.
    const bool upright = axes.dot(wedge.up) > upright_ * length;
    const Vector3d up = upright ? Vector3d(axes / length) : wedge.up;
    const double at_centre = up.dot(last.cross(first)) / (last_length * first_length);
    const double at_next = up.dot(first.cross(wedge.after_next)) / (first_length * wedge.after_next_length);
    const double at_opposite = up.dot(wedge.opposite_area) / (wedge.after_next_length * wedge.before_previous_length);
    const double at_previous = up.dot(wedge.before_previous.cross(last)) / (wedge.before_previous_length * last_length);
    const double most = upright ? 1.0 : 0.0;
    const double changing = std::min({most, at_centre, at_next, at_previous});
    return {std::min(changing, at_opposite), changing, 0.25 * (at_centre + at_next + at_opposite + at_previous),
            longest / shortest};
}

Star::Quality Star::quality(const Point& p) const {
    return Quality::of_faces(size_, [&](int i) { return quality(wedges_[static_cast<std::size_t>(i)], p); });
}

int Star::crossed(const Point& p) const {
    int count = 0;
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        if (!w.quad) continue;
        const Vector3d axes = (w.opposite - p).cross(w.previous - w.next);
        const std::array<Vector3d, 4> edge{w.next - p, w.opposite - w.next, w.previous - w.opposite, p - w.previous};
        bool is_convex = true;
        for (std::size_t k = 0; k < 4; ++k) is_convex = is_convex && axes.dot(edge[(k + 3) % 4].cross(edge[k])) > 0.0;
        count += is_convex ? 0 : 1;
    }
    return count;
}

double Star::tangle(const Point& p) const {
    const double least = kLeastCornerArea * edge_length_ * edge_length_;
    double sum = 0.0;
    const auto add = [&](double area) {
        const double lack = std::max(0.0, least - area);
        sum += lack * lack;
    };
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        add(w.up.dot((w.next - p).cross(w.previous - p)));
        if (!w.quad) continue;
        add(w.up.dot((w.opposite - w.next).cross(p - w.next)));
        add(w.up.dot((p - w.previous).cross(w.opposite - w.previous)));
    }
    return sum / (least * least);
}

}  // namespace anisoquad
