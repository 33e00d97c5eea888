#include "surface/reference_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parallel.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kLiftOfHeight = 0.1;  ///< limits of the lift off a facet
constexpr double kLiftOfDiagonal = 5e-4;
constexpr double kAway = -0.5;    ///< cosine between a facet and a direction from which it faces away
constexpr double kThin = 2e-3;    ///< distance of a sheet's other side, over the diagonal, that is looked at
constexpr double kFarther = 2.0;  ///< and over the distance of the closest facet

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

ReferenceSurface::ReferenceSurface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                                   std::span<const std::int32_t> facet_patch, double crease_angle, const Context& context)
    : tree_({points.begin(), points.end()}, {triangles.begin(), triangles.end()}, {facet_patch.begin(), facet_patch.end()},
            context) {
    compute_normals(crease_angle, context);
}

void ReferenceSurface::compute_normals(double crease_angle, const Context& context) {
    facet_normal_.resize(at(facet_count()));
    for_each(facet_count(), context, [&](std::int32_t f) {
        const auto& [a, b, c] = tree_.facet(f);
        facet_normal_[at(f)] = (tree_.point(b) - tree_.point(a)).cross(tree_.point(c) - tree_.point(a)).stableNormalized();
    });
    lift_limit_.resize(at(facet_count()));
    for_each(facet_count(), context, [&](std::int32_t f) {
        const double limit = std::min(kLiftOfHeight * tree_.height(f), kLiftOfDiagonal * diagonal());
        // Rounded down: what is lifted by as much as it may be is still near the surface to all who ask (Star::stays_near()).
        lift_limit_[at(f)] = std::nextafter(static_cast<float>(limit), 0.0F);
    });
    const double crease = std::cos(crease_angle * std::numbers::pi / 180.0);
    const auto corner_of = [this](std::int32_t facet, std::int32_t v) {
        const auto& t = tree_.facet(facet);
        return t[0] == v ? 0 : (t[1] == v ? 1 : 2);
    };
    std::vector<std::array<double, 3>> angle(at(facet_count()));
    for_each(facet_count(), context, [&](std::int32_t f) {
        const auto& t = tree_.facet(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d a = tree_.point(t[(k + 1) % 3]) - tree_.point(t[k]);
            const Vector3d b = tree_.point(t[(k + 2) % 3]) - tree_.point(t[k]);
            angle[at(f)][k] = std::atan2(a.cross(b).norm(), a.dot(b));
        }
    });
    const auto weighted = [&](std::int32_t facet, int k) -> Vector3d {
        return angle[at(facet)][at(k)] * facet_normal_[at(facet)];
    };
    corner_normal_.resize(at(facet_count()));
    for_each(facet_count(), context, [&](std::int32_t f) {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t v = tree_.facet(f)[at(k)];
            Vector3d sum = weighted(f, k);
            // Both ways round the vertex until an edge separates; a closed fan is done after the first way.
            bool full_turn = false;
            for (int way = 0; way < 2 && !full_turn; ++way) {
                std::int32_t facet = f;
                for (std::int32_t guard = 0; guard < facet_count(); ++guard) {
                    const int corner = corner_of(facet, v);
                    const std::int32_t across = tree_.neighbour(facet, way == 0 ? (corner + 2) % 3 : corner);
                    if (across < 0 || tree_.patch(across) != tree_.patch(f) ||
                        facet_normal_[at(across)].dot(facet_normal_[at(facet)]) < crease) {
                        break;
                    }
                    if (across == f) {
                        full_turn = true;
                        break;
                    }
                    sum += weighted(across, corner_of(across, v));
                    facet = across;
                }
            }
            corner_normal_[at(f)][at(k)] = (sum.norm() > 0.0 ? Vector3d(sum.normalized()) : facet_normal_[at(f)]).cast<float>();
        }
    });
}

Vector3d ReferenceSurface::interpolated_normal(const FacetTree::Hit& c) const {
    const auto& n = corner_normal_[at(c.facet)];
    const Vector3d sum =
        c.weights[0] * n[0].cast<double>() + c.weights[1] * n[1].cast<double>() + c.weights[2] * n[2].cast<double>();
    return sum.norm() > 0.0 ? Vector3d(sum.normalized()) : facet_normal_[at(c.facet)];
}

FacetTree::Hit ReferenceSurface::hit(const Point& p, const Sheet& sheet, std::int32_t hint) const {
    const FacetTree::Hit closest = tree_.closest(p, sheet.patch, hint);
    if (closest.facet < 0) return closest;
    const double facing = facet_normal_[at(closest.facet)].dot(sheet.up);
    if (facing >= 0.0 || facing >= kAway * sheet.up.norm()) return closest;
    const double reach = std::max(kThin * diagonal(), kFarther * std::sqrt(closest.distance2));
    const FacetTree::Hit other = tree_.closest_facing(p, sheet.patch, sheet.up, reach);
    return other.facet >= 0 ? other : closest;
}

SurfacePoint ReferenceSurface::closest(const Point& p, const Sheet& sheet) const { return closest(p, sheet, -1); }

SurfacePoint ReferenceSurface::closest(const Point& p, const Sheet& sheet, std::int32_t hint) const {
    const FacetTree::Hit c = hit(p, sheet, hint);
    if (c.facet < 0) return {};
    return {c.position, c.facet, std::sqrt(c.distance2), interpolated_normal(c)};
}

double ReferenceSurface::distance(const Point& p, std::int32_t patch, double enough, std::int32_t& hint) const {
    const FacetTree::Hit c = tree_.closest_or_within(p, patch, hint, enough * enough);
    hint = c.facet;
    return c.facet >= 0 ? std::sqrt(c.distance2) : 0.0;
}

TargetPlace ReferenceSurface::place(const Point& p, std::int32_t patch, std::int32_t& hint) const {
    const FacetTree::Hit c = tree_.closest(p, patch, hint);
    if (c.facet >= 0) hint = c.facet;
    return {c.facet, c.weights};
}

Point ReferenceSurface::project(const Point& p, const Sheet& sheet, std::int32_t& hint) const {
    const FacetTree::Hit c = hit(p, sheet, hint);
    if (c.facet < 0) return p;
    hint = c.facet;
    if (target_) {
        Point moved = p;
        const TargetPlace place{c.facet, c.weights};
        target_.project(std::span(&place, 1), std::span(&moved, 1));
        return moved;
    }
    const auto& t = tree_.facet(c.facet);
    Vector3d lift = Vector3d::Zero();
    for (std::int32_t k = 0; k < 3; ++k) {
        const Vector3d n = corner_normal_[at(c.facet)][at(k)].cast<double>();
        lift += 0.5 * c.weights[k] * (tree_.point(t[at(k)]) - c.position).dot(n) * n;
    }
    const double limit = lift_limit_[at(c.facet)];
    const double length2 = lift.squaredNorm();
    return length2 > limit * limit ? Point(c.position + limit / std::sqrt(length2) * lift) : Point(c.position + lift);
}

}  // namespace anisoquad
