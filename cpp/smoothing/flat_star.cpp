#include "smoothing/flat_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace anisoquad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A symmetric matrix.
struct Symmetric {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void add(double weight, const Symmetric& m) {
        xx += weight * m.xx;
        xy += weight * m.xy;
        yy += weight * m.yy;
    }
    void add_square(double weight, const Vector2d& a) {
        xx += weight * a.x() * a.x();
        xy += weight * a.x() * a.y();
        yy += weight * a.y() * a.y();
    }
};

/// An edge at the node, with the derivatives of its direction and of its length's logarithm by the node's place.
struct Moving {
    double length2;
    Vector2d unit;
    Vector2d direction;  ///< gradient of the angle
    Vector2d growth;     ///< gradient of the logarithm of the length
    Symmetric bend;      ///< second derivatives of the angle
    Symmetric growth_curve;

    /// @param sign of the edge's change by the node's: −1 where it starts at the node
    Moving(const Vector2d& edge, double sign) : length2(edge.squaredNorm()), unit(edge / std::sqrt(length2)) {
        const Vector2d over = edge / length2;
        direction = sign * Vector2d(-over.y(), over.x());
        growth = sign * over;
        const double a = 2.0 * over.x() * over.y();
        const double b = over.y() * over.y() - over.x() * over.x();
        bend = {a, b, -a};
        growth_curve = {b, -a, -b};
    }
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
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[static_cast<std::size_t>(i)];
        w.next = coordinates(star.next(i));
        w.previous = coordinates(star.previous(i));
        w.opposite = coordinates(star.opposite(i));
        w.after_next = w.opposite - w.next;
        w.before_previous = w.previous - w.opposite;
        const double a2 = w.after_next.squaredNorm();
        const double b2 = w.before_previous.squaredNorm();
        w.shortest2 = std::min(a2, b2);
        w.longest2 = std::max(a2, b2);
        // An edge without length has no direction.
        w.after_next *= a2 > 0.0 ? 1.0 / std::sqrt(a2) : 0.0;
        w.before_previous *= b2 > 0.0 ? 1.0 / std::sqrt(b2) : 0.0;
        w.at_opposite = cross(w.after_next, w.before_previous);
    }
}

Star::FaceQuality FlatStar::quality(const Wedge& w, const Vector2d& x) {
    const Vector2d first = w.next - x;
    const Vector2d last = x - w.previous;
    const double f2 = first.squaredNorm();
    const double l2 = last.squaredNorm();
    const double shortest2 = std::min({w.shortest2, f2, l2});
    if (!(shortest2 > 0.0)) return {};
    const Vector2d f = first / std::sqrt(f2);
    const Vector2d l = last / std::sqrt(l2);
    const double at_centre = cross(l, f);
    const double at_next = cross(f, w.after_next);
    const double at_previous = cross(w.before_previous, l);
    const bool upright = cross(w.opposite - x, w.previous - w.next) > 0.0;
    const double changing = std::min({upright ? 1.0 : 0.0, at_centre, at_next, at_previous});
    return {std::min(changing, w.at_opposite), changing, 0.25 * (at_centre + at_next + w.at_opposite + at_previous),
            std::sqrt(std::max({w.longest2, f2, l2}) / shortest2)};
}

Star::Quality FlatStar::quality(const Vector2d& x) const {
    return Star::Quality::of_faces(size_, [&](int i) { return quality(wedges_[static_cast<std::size_t>(i)], x); });
}

FlatStar::Derivatives FlatStar::derivatives() const {
    Vector2d gradient = Vector2d::Zero();
    Symmetric hessian;
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        const Moving first(w.next, -1.0);
        const Moving last(-w.previous, 1.0);
        if (!(first.length2 > 0.0) || !(last.length2 > 0.0)) continue;
        // Sines of the differences of the directions of the edges round the quad, at the three corners that change.
        const double at_centre = last.unit.dot(first.unit);  // cosines
        const double at_next = first.unit.dot(w.after_next);
        const double at_previous = w.before_previous.dot(last.unit);
        const Vector2d turn = first.direction - last.direction;
        gradient += 0.25 * (at_centre * turn - at_next * first.direction + at_previous * last.direction);
        hessian.add_square(-0.25 * cross(last.unit, first.unit), turn);
        hessian.add_square(-0.25 * cross(first.unit, w.after_next), first.direction);
        hessian.add_square(-0.25 * cross(w.before_previous, last.unit), last.direction);
        hessian.add(0.25 * (at_centre - at_next), first.bend);
        hessian.add(0.25 * (at_previous - at_centre), last.bend);

        // The logarithm of the longest over the shortest edge, where one of them changes.
        Stretch longest{w.longest2};
        Stretch shortest{w.shortest2};
        for (const Moving* edge : {&first, &last}) {
            if (edge->length2 > longest.length2) longest = {edge->length2, edge};
            if (edge->length2 < shortest.length2) shortest = {edge->length2, edge};
        }
        if (!(shortest.length2 > 0.0) || longest.edge == shortest.edge) continue;
        const double ratio = std::sqrt(longest.length2 / shortest.length2);
        const double s = Star::Quality::stretch_of(ratio);
        // Derivatives of s by the logarithm of the ratio.
        const double s1 = 4.0 * ratio / ((ratio + 1.0) * (ratio + 1.0));
        const double s2 = s1 * (1.0 - ratio) / (1.0 + ratio);
        const double slope_weight = -2.0 * Star::kStretchWeight * s * s1;
        Vector2d slope = Vector2d::Zero();
        if (longest.edge) {
            slope += longest.edge->growth;
            hessian.add(slope_weight, longest.edge->growth_curve);
        }
        if (shortest.edge) {
            slope -= shortest.edge->growth;
            hessian.add(-slope_weight, shortest.edge->growth_curve);
        }
        gradient += slope_weight * slope;
        hessian.add_square(-2.0 * Star::kStretchWeight * (s1 * s1 + s * s2), slope);
    }
    return {gradient / size_, Matrix2d{{hessian.xx, hessian.xy}, {hessian.xy, hessian.yy}} / size_};
}

}  // namespace anisoquad
