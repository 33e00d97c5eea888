#include "smoothing/flat_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace anisoquad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Squares of lengths nearer than this to each other are equal: of a parallelogram's edges, as the fill leaves them, rounding must
/// not choose the longest.
constexpr double kLonger = 1.0 + 1e-9;

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

/// An edge from the node to one of its ring, with the derivatives of its direction and of its length's logarithm by the node's
/// place.
struct Spoke {
    double length2;
    Vector2d unit;
    Vector2d direction;  ///< gradient of the angle
    Vector2d growth;     ///< gradient of the logarithm of the length
    Symmetric bend;      ///< second derivatives of the angle
    Symmetric growth_curve;

    Spoke() = default;
    Spoke(const Vector2d& edge, double length) {
        const double inverse = 1.0 / length;
        length2 = length * length;
        unit = inverse * edge;
        const Vector2d over = inverse * unit;
        direction = {over.y(), -over.x()};
        growth = -over;
        const double a = 2.0 * over.x() * over.y();
        const double b = over.y() * over.y() - over.x() * over.x();
        bend = {a, b, -a};
        growth_curve = {b, -a, -b};
    }
};

/// The longest or shortest edge of a quad; no edge: one that does not change.
struct Stretch {
    double length2;
    const Spoke* edge = nullptr;
};

}  // namespace

bool FlatStar::gather(const SurfaceMesh& mesh, Vertex v) {
    assert(!mesh.is_boundary(v));
    size_ = 0;
    centre_ = mesh.position(v);
    patch_ = mesh.info(mesh.face(mesh.halfedge(v))).patch;
    has_quads_only_ = true;
    std::array<Vector3d, Star::kCapacity> next;      // ways from the node
    std::array<Vector3d, Star::kCapacity> opposite;  // of a triangle: the previous node
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (size_ == Star::kCapacity) return false;
        const std::size_t i = at(size_++);
        const HalfEdge after = mesh.next(h);
        const HalfEdge third = mesh.next(after);
        next[i] = mesh.position(mesh.from(after)) - centre_;
        opposite[i] = mesh.position(mesh.from(third)) - centre_;
        wedges_[i].quad = third != mesh.prev(h);
        has_quads_only_ = has_quads_only_ && wedges_[i].quad;
    }
    // Clockwise round the node, a face's previous node is the next one of the face before.
    const auto previous = [&](int i) -> const Vector3d& { return next[at(i > 0 ? i - 1 : size_ - 1)]; };
    std::array<Vector3d, Star::kCapacity> area;
    normal_.setZero();
    for (int i = 0; i < size_; ++i) {
        area[at(i)] = opposite[at(i)].cross(previous(i) - next[at(i)]);
        normal_ += area[at(i)];
    }
    const double length = normal_.norm();
    if (!(length > 0.0)) return false;
    normal_ /= length;
    for (int i = 0; i < size_; ++i) {
        const double along = area[at(i)].dot(normal_);
        if (along < 0.0 || along * along < Star::kPlane * Star::kPlane * area[at(i)].squaredNorm()) return false;
    }
    first_ = normal_.unitOrthogonal();
    second_ = normal_.cross(first_);
    edge_length_ = 0.0;
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[at(i)];
        w.next = drawn(next[at(i)]);
        w.length = w.next.norm();
        edge_length_ += w.length;
    }
    edge_length_ /= size_;
    for (int i = 0; i < size_; ++i) {
        Wedge& w = wedges_[at(i)];
        w.previous = wedges_[at(i > 0 ? i - 1 : size_ - 1)].next;
        if (!w.quad) {
            w.longest2 = w.shortest2 = (w.previous - w.next).squaredNorm();
            continue;
        }
        w.opposite = drawn(opposite[at(i)]);
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
    return true;
}

Star::FaceQuality FlatStar::quality(const Wedge& w, const Vector2d& x) {
    const Vector2d first = w.next - x;
    const Vector2d last = x - w.previous;
    const double f2 = first.squaredNorm();
    const double l2 = last.squaredNorm();
    if (!w.quad) {
        const double area = cross(last, first);
        const double shape = Star::triangle_shape(std::abs(area), f2 + l2 + w.longest2);
        const double quality = area > 0.0 ? shape : -shape;
        return {quality, quality, quality, 1.0};
    }
    const double shortest2 = std::min({w.shortest2, f2, l2});
    if (!(shortest2 > 0.0)) return {};
    const Vector2d f = first * (1.0 / std::sqrt(f2));
    const Vector2d l = last * (1.0 / std::sqrt(l2));
    const double at_centre = cross(l, f);
    const double at_next = cross(f, w.after_next);
    const double at_previous = cross(w.before_previous, l);
    const bool upright = cross(w.opposite - x, w.previous - w.next) > 0.0;
    const double changing = std::min({upright ? 1.0 : 0.0, at_centre, at_next, at_previous});
    return {std::min(changing, w.at_opposite), changing, 0.25 * (at_centre + at_next + w.at_opposite + at_previous),
            std::sqrt(std::max({w.longest2, f2, l2}) / shortest2)};
}

Star::Quality FlatStar::quality(const Vector2d& x) const {
    return Star::Quality::of_faces(size_, [&](int i) { return quality(wedges_[at(i)], x); });
}

FlatStar::Expansion FlatStar::expand() const {
    assert(has_quads_only_);
    std::array<Spoke, Star::kCapacity> spokes;
    for (int i = 0; i < size_; ++i) spokes[at(i)] = Spoke(wedges_[at(i)].next, wedges_[at(i)].length);
    Vector2d gradient = Vector2d::Zero();
    Symmetric hessian;
    const auto expand_face = [&](int i) -> Star::FaceQuality {
        const Wedge& w = wedges_[at(i)];
        const Spoke& first = spokes[at(i)];
        const Spoke& last = spokes[at(i > 0 ? i - 1 : size_ - 1)];  // round the quad its edge comes to the node
        // The longest and the shortest edge; those that change with the node have their spoke.
        Stretch longest{w.longest2};
        Stretch shortest{w.shortest2};
        for (const Spoke* edge : {&first, &last}) {
            if (edge->length2 > longest.length2 * kLonger) longest = {edge->length2, edge};
            if (edge->length2 * kLonger < shortest.length2) shortest = {edge->length2, edge};
        }
        if (!(shortest.length2 > 0.0)) return {};
        const double ratio = std::sqrt(longest.length2 / shortest.length2);

        // Sines of the differences of the directions of the edges round the quad, at the three corners that change.
        const double at_centre = cross(first.unit, last.unit);
        const double at_next = cross(first.unit, w.after_next);
        const double at_previous = cross(last.unit, w.before_previous);
        const double cos_centre = -last.unit.dot(first.unit);
        const double cos_next = first.unit.dot(w.after_next);
        const double cos_previous = -w.before_previous.dot(last.unit);
        const Vector2d turn = first.direction - last.direction;
        gradient += 0.25 * (cos_centre * turn - cos_next * first.direction + cos_previous * last.direction);
        hessian.add_square(-0.25 * at_centre, turn);
        hessian.add_square(-0.25 * at_next, first.direction);
        hessian.add_square(-0.25 * at_previous, last.direction);
        hessian.add(0.25 * (cos_centre - cos_next), first.bend);
        hessian.add(0.25 * (cos_previous - cos_centre), last.bend);

        // The logarithm of the longest over the shortest edge, where one of them changes.
        if (longest.edge != shortest.edge) {
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

        const bool upright = cross(w.opposite, w.previous - w.next) > 0.0;
        const double changing = std::min({upright ? 1.0 : 0.0, at_centre, at_next, at_previous});
        return {std::min(changing, w.at_opposite), changing, 0.25 * (at_centre + at_next + w.at_opposite + at_previous), ratio};
    };
    const Star::Quality quality = Star::Quality::of_faces(size_, expand_face);
    return {quality, gradient / size_, Matrix2d{{hessian.xx, hessian.xy}, {hessian.xy, hessian.yy}} / size_};
}

}  // namespace anisoquad
