#include "smoothing/flat_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace anisoquad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// An edge at the node, with the derivatives of its direction and of its length's logarithm by the node's place.
struct Moving {
    Vector2d edge;
    double sign;  ///< of the edge's change by the node's: −1 where it starts at the node
    double length2;
    Vector2d direction;  ///< gradient of the angle

    Moving(const Vector2d& e, double s)
        : edge(e), sign(s), length2(e.squaredNorm()), direction(s / length2 * Vector2d(-e.y(), e.x())) {}
    /// Second derivatives of the angle.
    Matrix2d bend() const {
        const double a = 2.0 * edge.x() * edge.y();
        const double b = edge.y() * edge.y() - edge.x() * edge.x();
        return Matrix2d{{a, b}, {b, -a}} / (length2 * length2);
    }
    Vector2d growth() const { return sign / length2 * edge; }
    Matrix2d growth_curve() const { return Matrix2d::Identity() / length2 - 2.0 / (length2 * length2) * edge * edge.transpose(); }
};

/// The longest or shortest edge of a quad; no edge: one that does not change.
struct Stretch {
    double length2;
    const Moving* edge = nullptr;
};

}  // namespace

FlatStar::FlatStar(const Star& star) : size_(star.size()), centre_(star.centre()) {
    first_ = star.normal().unitOrthogonal();
    second_ = star.normal().cross(first_);
    const auto flat = [&](const Point& p) -> Vector2d { return {(p - centre_).dot(first_), (p - centre_).dot(second_)}; };
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[static_cast<std::size_t>(i)];
        w.next = flat(star.next(i));
        w.previous = flat(star.previous(i));
        const Vector2d opposite = flat(star.opposite(i));
        w.after_next = opposite - w.next;
        w.before_previous = w.previous - opposite;
        const double a2 = w.after_next.squaredNorm();
        const double b2 = w.before_previous.squaredNorm();
        w.shortest2 = std::min(a2, b2);
        w.longest2 = std::max(a2, b2);
        // An edge without length has no direction.
        w.after_next *= a2 > 0.0 ? 1.0 / std::sqrt(a2) : 0.0;
        w.before_previous *= b2 > 0.0 ? 1.0 / std::sqrt(b2) : 0.0;
    }
}

FlatStar::Derivatives FlatStar::derivatives() const {
    Derivatives sum;
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        const Moving first(w.next, -1.0);
        const Moving last(-w.previous, 1.0);
        if (!(first.length2 > 0.0) || !(last.length2 > 0.0)) continue;
        // Sines of the differences of the directions of the edges round the quad, at the three corners that change.
        const Vector2d f = first.edge / std::sqrt(first.length2);
        const Vector2d l = last.edge / std::sqrt(last.length2);
        const Vector2d turn = first.direction - last.direction;
        sum.gradient +=
            0.25 * (l.dot(f) * turn - f.dot(w.after_next) * first.direction + w.before_previous.dot(l) * last.direction);
        sum.hessian -= 0.25 * (cross(l, f) * turn * turn.transpose() +
                               cross(f, w.after_next) * first.direction * first.direction.transpose() +
                               cross(w.before_previous, l) * last.direction * last.direction.transpose());
        sum.hessian +=
            0.25 * ((l.dot(f) - f.dot(w.after_next)) * first.bend() + (w.before_previous.dot(l) - l.dot(f)) * last.bend());

        // The logarithm of the longest over the shortest edge, where one of them changes.
        Stretch longest{w.longest2};
        Stretch shortest{w.shortest2};
        for (const Moving* edge : {&first, &last}) {
            if (edge->length2 > longest.length2) longest = {edge->length2, edge};
            if (edge->length2 < shortest.length2) shortest = {edge->length2, edge};
        }
        if (!(shortest.length2 > 0.0) || longest.edge == shortest.edge) continue;
        const double ratio = std::sqrt(longest.length2 / shortest.length2);
        const double s = 2.0 * (ratio - 1.0) / (ratio + 1.0);
        // Derivatives of s by the logarithm of the ratio.
        const double s1 = 4.0 * ratio / ((ratio + 1.0) * (ratio + 1.0));
        const double s2 = s1 * (1.0 - ratio) / (1.0 + ratio);
        Vector2d slope = Vector2d::Zero();
        Matrix2d curve = Matrix2d::Zero();
        if (longest.edge) {
            slope += longest.edge->growth();
            curve += longest.edge->growth_curve();
        }
        if (shortest.edge) {
            slope -= shortest.edge->growth();
            curve -= shortest.edge->growth_curve();
        }
        sum.gradient -= 2.0 * Star::kStretchWeight * s * s1 * slope;
        sum.hessian -= 2.0 * Star::kStretchWeight * ((s1 * s1 + s * s2) * slope * slope.transpose() + s * s1 * curve);
    }
    sum.gradient /= size_;
    sum.hessian /= size_;
    return sum;
}

}  // namespace anisoquad
