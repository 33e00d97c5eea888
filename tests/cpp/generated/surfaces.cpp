#include "generated/surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "generated/kinds.h"
#include "input/repair.h"

namespace anisoquad::generated {
namespace {

using shapes::Shape;
constexpr double kPi = std::numbers::pi;

/// Bends the part beyond a line by up to nearly half a turn.
void fold(Shape& shape, ByteSource& source) {
    const double place = 0.8 * source.signed_fraction();
    const double turn = source.one_in(4) ? 0.999 * kPi : kPi * source.signed_fraction();
    const double round = source.one_in(2) ? 0.0 : 0.5;
    for (Point& p : shape.points) {
        const double beyond = p.x() - place;
        if (beyond <= 0.0) continue;
        const double angle = round > 0.0 ? turn * std::min(1.0, beyond / round) : turn;
        p = Point(place + beyond * std::cos(angle) - p.z() * std::sin(angle), p.y(),
                  beyond * std::sin(angle) + p.z() * std::cos(angle));
    }
}

/// Sizes that grow by up to 1000 from one side to the other.
void grade(Shape& shape, ByteSource& source) {
    const double k = std::log(1.0 + 999.0 * source.fraction() * source.fraction());
    const auto axis = static_cast<Eigen::Index>(source.below(3));
    if (k < 1e-3) return;
    for (Point& p : shape.points) p[axis] = (std::exp(k * (p[axis] + 1.0) / 2.0) - 1.0) / std::exp(k / 2.0);
}

void stretch(Shape& shape, ByteSource& source) {
    const auto axis = static_cast<Eigen::Index>(source.below(3));
    const double factor = 1.0 + 49.0 * source.fraction();
    for (Point& p : shape.points) p[axis] *= factor;
}

/// A neck at x = 0.
void pinch(Shape& shape, ByteSource& source) {
    const double least = 0.01 + 0.5 * source.fraction();
    for (Point& p : shape.points) {
        const double share = least + (1.0 - least) * std::min(1.0, p.x() * p.x());
        p.y() *= share;
        p.z() *= share;
    }
}

void wave(Shape& shape, ByteSource& source) {
    const double height = 0.5 * source.fraction();
    const double length = 0.5 + 3.0 * source.fraction();
    for (Point& p : shape.points) p.z() += height * std::sin(length * p.x()) * std::cos(length * p.y());
}

/// Moves every node by a share of its shortest edge.
void jitter(Shape& shape, ByteSource& source) {
    std::vector<double> shortest(shape.points.size(), std::numeric_limits<double>::infinity());
    for (const auto& t : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(t[k]);
            const auto b = static_cast<std::size_t>(t[(k + 1) % 3]);
            const double length = (shape.points[a] - shape.points[b]).norm();
            shortest[a] = std::min(shortest[a], length);
            shortest[b] = std::min(shortest[b], length);
        }
    }
    const double amount = 0.45 * source.fraction();
    auto state = static_cast<std::uint32_t>(source.byte());
    const auto next = [&state] {
        state = 1664525u * state + 1013904223u;
        return (state >> 8) / static_cast<double>(1u << 24) - 0.5;
    };
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        if (std::isfinite(shortest[i])) shape.points[i] += amount * shortest[i] * Point(next(), next(), next());
    }
}

/// A tip: one node goes far out.
void pull(Shape& shape, ByteSource& source) {
    Point& p = shape.points[static_cast<std::size_t>(source.below(static_cast<int>(shape.points.size())))];
    p += 5.0 * source.fraction() * Point(source.signed_fraction(), source.signed_fraction(), source.signed_fraction());
}

/// Back to about 2 × 2: modifiers one after the other would reach any size.
void normalise(Shape& shape) {
    double size = 0.0;
    for (const Point& p : shape.points) size = std::max(size, p.cwiseAbs().maxCoeff());
    if (size > 0.0) shape = shapes::placed(std::move(shape), 1.0 / size, Point::Zero());
}

void modify(Shape& shape, ByteSource& source) {
    const int steps = source.below(4);
    for (int i = 0; i < steps && !shape.points.empty(); ++i) {
        switch (source.below(8)) {
            case 0: fold(shape, source); break;
            case 1: grade(shape, source); break;
            case 2: stretch(shape, source); break;
            case 3: pinch(shape, source); break;
            case 4: wave(shape, source); break;
            case 5: pull(shape, source); break;
            default: jitter(shape, source); break;
        }
        normalise(shape);
    }
}

/// What the modifiers may have made degenerate or pinched is mended; the rest stays as it is.
Shape made_valid(const Shape& shape) {
    RepairResult mended = repair_surface(shape.points, shape.triangles);
    return {std::move(mended.points), std::move(mended.triangles)};
}

}  // namespace

Shape make_surface(ByteSource& source, double extent) {
    Shape shape = make_kind(source, extent);
    modify(shape, source);
    while (source.one_in(8) && shape.triangles.size() < 200) {
        Shape other = make_kind(source, extent);
        modify(other, source);
        shape = shapes::joined(std::move(shape), shapes::placed(std::move(other), 0.05 + source.fraction(), {5, 0, 0}));
    }
    if (source.one_in(4)) {
        const double scale = std::pow(10.0, 12.0 * source.signed_fraction());
        const double far = scale * std::pow(10.0, 4.0 * source.fraction());
        shape = shapes::placed(std::move(shape), scale, far * Point(source.signed_fraction(), source.signed_fraction(), 0.3));
    }
    return made_valid(shape);
}

void spoil(Shape& shape, ByteSource& source) {
    const int steps = source.between(1, 5);
    for (int i = 0; i < steps && !shape.triangles.empty(); ++i) {
        auto& t = shape.triangles[static_cast<std::size_t>(source.below(static_cast<int>(shape.triangles.size())))];
        auto& corner = t[static_cast<std::size_t>(source.below(3))];
        const auto vertex = source.below(static_cast<int>(shape.points.size()));
        Point& p = shape.points[static_cast<std::size_t>(vertex)];
        switch (source.below(10)) {
            case 0: std::swap(t[0], t[1]); break;
            case 1: corner = vertex; break;
            case 2: corner = source.one_in(2) ? -1 : 1 << 30; break;
            case 3: p.x() = std::numeric_limits<double>::quiet_NaN(); break;
            case 4: p *= source.one_in(2) ? 1e200 : std::numeric_limits<double>::infinity(); break;
            case 5: p = shape.points[static_cast<std::size_t>(source.below(static_cast<int>(shape.points.size())))]; break;
            case 6: shape.triangles.push_back(std::array<std::int32_t, 3>(t)); break;
            case 7: shape.triangles.push_back({t[0], t[1], vertex}); break;
            case 8: t = shape.triangles.back(); break;
            default:
                shape.points.push_back(Point(shape.points[static_cast<std::size_t>(std::max(0, std::min(vertex, corner)))]));
                corner = static_cast<std::int32_t>(shape.points.size()) - 1;
        }
    }
}

}  // namespace anisoquad::generated
