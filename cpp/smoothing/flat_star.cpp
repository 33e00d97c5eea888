#include "smoothing/flat_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace anisoquad {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

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
        // An edge without length has no direction: its sines are 0 as in a degenerate quad.
        w.after_next *= a2 > 0.0 ? 1.0 / std::sqrt(a2) : 0.0;
        w.before_previous *= b2 > 0.0 ? 1.0 / std::sqrt(b2) : 0.0;
        w.opposite_sine = cross(w.after_next, w.before_previous);
    }
}

double FlatStar::score(const Vector2d& x) const {
    double mean = 0.0;
    double lack = 0.0;
    double stretch = 0.0;
    for (int i = 0; i < size_; ++i) {
        const Wedge& w = wedges_[static_cast<std::size_t>(i)];
        const Vector2d first = w.next - x;
        const Vector2d last = x - w.previous;
        const double first2 = first.squaredNorm();
        const double last2 = last.squaredNorm();
        const double shortest2 = std::min({first2, last2, w.shortest2});
        const double longest2 = std::max({first2, last2, w.longest2});
        double quality = -1.0;
        double ratio = 1.0;
        if (shortest2 > 0.0) {
            const double by_first = 1.0 / std::sqrt(first2);
            const double by_last = 1.0 / std::sqrt(last2);
            quality = std::min({by_first * by_last * cross(last, first), by_first * cross(first, w.after_next),
                                by_last * cross(w.before_previous, last), w.opposite_sine});
            ratio = std::sqrt(longest2 / shortest2);
        }
        const double missing = std::max(0.0, Star::kPoor - quality);
        const double s = 2.0 * (ratio - 1.0) / (ratio + 1.0);
        mean += quality;
        lack += missing * missing;
        stretch += s * s;
    }
    return (mean - lack - Star::kStretchWeight * stretch) / size_;
}

}  // namespace anisoquad
