#include "cad/closest_point.h"

#include <Eigen/LU>
#include <Geom_BSplineCurve.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cad/face_samples.h"
#include "cad/to_eigen.h"

namespace anisoquad::cad {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kIterations = 40;
constexpr int kHalvings = 12;
constexpr double kNoWorse = 1.0 + 1e-13;  ///< squared distances do not tell the last steps apart
constexpr double kStepAtRest = 1e-12;     ///< over the distance of the point from the origin, and the size of what it is on
constexpr double kFlat = 1e-12;           ///< of a length of a derivative over the larger one: a pole
constexpr int kStarts = 3;                ///< of the samples, tried in the order of their distance
constexpr int kSamples = 48;              ///< of an edge, at the least
constexpr int kSamplesPerSpan = 8;

struct Derivatives {
    Vector3d r, u, v, uu, uv, vv;  ///< r: from the point to the surface

    Derivatives(const CadFace& face, const Vector3d& p, const Vector2d& x) {
        gp_Pnt s;
        gp_Vec su, sv, suu, svv, suv;
        face.surface->D2(x[0], x[1], s, su, sv, suu, svv, suv);
        r = to_eigen(s) - p;
        u = to_eigen(su);
        v = to_eigen(sv);
        uu = to_eigen(suu);
        uv = to_eigen(suv);
        vv = to_eigen(svv);
    }
    Vector2d gradient() const { return {r.dot(u), r.dot(v)}; }
    /// Of half the squared distance; without the curvature's part where that would lead uphill.
    Matrix2d hessian() const {
        Matrix2d h;
        h << u.dot(u) + r.dot(uu), u.dot(v) + r.dot(uv), u.dot(v) + r.dot(uv), v.dot(v) + r.dot(vv);
        if (h(0, 0) > 0.0 && h.determinant() > 1e-8 * h(0, 0) * h(1, 1)) return h;
        h << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
        const double largest = std::max(h(0, 0), h(1, 1));
        h(0, 0) += 1e-8 * largest;
        h(1, 1) += 1e-8 * largest;
        return h;
    }
};

Vector3d value(const CadFace& face, const Vector2d& x) { return to_eigen(face.surface->Value(x[0], x[1])); }

Vector2d held(const CadFace& face, Vector2d x) {
    for (Eigen::Index k = 0; k < 2; ++k) {
        const Range& r = face.range[static_cast<std::size_t>(k)];
        if (!r.periodic) x[k] = std::clamp(x[k], r.low, r.high);
    }
    return x;
}

/// Newton's step, along an end of the range where it would lead beyond.
Vector2d newton_step(const CadFace& face, const Derivatives& d, const Vector2d& x) {
    const Vector2d g = d.gradient();
    const Matrix2d h = d.hessian();
    Vector2d step = -h.inverse() * g;
    for (Eigen::Index k = 0; k < 2; ++k) {
        const Range& r = face.range[static_cast<std::size_t>(k)];
        if (r.periodic || !((x[k] <= r.low && -g[k] <= 0.0) || (x[k] >= r.high && -g[k] >= 0.0))) continue;
        const Eigen::Index other = 1 - k;
        step[k] = 0.0;
        step[other] = -g[other] / h(other, other);
    }
    return step;
}

FacePoint descend(const CadFace& face, const Vector3d& p, const Vector2d& start) {
    Vector2d x = held(face, start);
    Derivatives d(face, p, x);
    double squared = d.r.squaredNorm();
    FacePoint result;
    for (int i = 0; i < kIterations && !result.converged; ++i) {
        const Vector2d step = newton_step(face, d, x);
        const double rest = kStepAtRest * (p.cwiseAbs().maxCoeff() + d.r.norm());
        if (!step.allFinite()) break;
        Vector2d next = x;
        double better = squared;
        bool found = false;
        double share = 1.0;
        for (int k = 0; k < kHalvings && !found; ++k, share *= 0.5) {
            next = held(face, x + share * step);
            better = (value(face, next) - p).squaredNorm();
            found = better <= squared * kNoWorse;
        }
        const Vector2d moved = next - x;
        result.converged = !found || std::abs(moved[0]) * d.u.norm() + std::abs(moved[1]) * d.v.norm() <= rest;
        if (!found) break;
        x = next;
        squared = better;
        d = Derivatives(face, p, x);
    }
    result.parameter = x;
    result.position = d.r + p;
    result.distance = std::sqrt(squared);
    return result;
}

}  // namespace

FacePoint closest_on_face(const CadFace& face, const Vector3d& p, const Vector2d& start) {
    FacePoint best = descend(face, p, start);
    for (Eigen::Index k = 0; k < 2; ++k) {
        const Range& r = face.range[static_cast<std::size_t>(k)];
        if (!r.closed || r.periodic || (best.parameter[k] > r.low && best.parameter[k] < r.high)) continue;
        Vector2d round = best.parameter;
        round[k] = round[k] <= r.low ? r.high : r.low;
        const FacePoint other = descend(face, p, round);
        if (other.distance < best.distance) best = other;
    }
    return best;
}

FacePoint closest_on_face(const CadFace& face, const Vector3d& p) {
    const FaceSamples& samples = samples_of(face);
    std::array<std::pair<double, std::size_t>, kStarts> nearest;
    nearest.fill({std::numeric_limits<double>::infinity(), 0});
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const double squared = (samples.points[i] - p).squaredNorm();
        if (!(squared < nearest.back().first)) continue;
        std::size_t k = nearest.size() - 1;
        for (; k > 0 && squared < nearest[k - 1].first; --k) nearest[k] = nearest[k - 1];
        nearest[k] = {squared, i};
    }
    FacePoint best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const auto& [squared, i] : nearest) {
        const FacePoint found = closest_on_face(face, p, samples.parameters[i]);
        if (found.distance < best.distance) best = found;
    }
    return best;
}

Vector3d face_normal(const CadFace& face, const Vector2d& parameter) {
    gp_Pnt s;
    gp_Vec su, sv;
    face.surface->D1(parameter[0], parameter[1], s, su, sv);
    const Vector3d u = to_eigen(su);
    const Vector3d v = to_eigen(sv);
    const Vector3d n(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
    if (!(n.norm() > kFlat * std::max(u.squaredNorm(), v.squaredNorm()))) return Vector3d::Zero();
    return face.reversed ? Vector3d(-n.normalized()) : Vector3d(n.normalized());
}

EdgePoint closest_on_edge(const CadEdge& edge, const Vector3d& p, double start) {
    double t = std::clamp(start, edge.range.low, edge.range.high);
    gp_Pnt c;
    gp_Vec d1, d2;
    edge.curve->D2(t, c, d1, d2);
    Vector3d r = to_eigen(c) - p;
    EdgePoint result;
    for (int i = 0; i < kIterations && !result.converged; ++i) {
        const Vector3d u = to_eigen(d1);
        const double g = r.dot(u);
        double h = u.squaredNorm() + r.dot(to_eigen(d2));
        if (!(h > 1e-8 * u.squaredNorm())) h = u.squaredNorm();
        const double rest = kStepAtRest * (p.cwiseAbs().maxCoeff() + r.norm());
        double step = -g / h;
        if (!std::isfinite(step)) break;
        double next = t;
        Vector3d there = r;
        bool found = false;
        for (int k = 0; k < kHalvings && !found; ++k, step *= 0.5) {
            next = std::clamp(t + step, edge.range.low, edge.range.high);
            there = to_eigen(edge.curve->Value(next)) - p;
            found = there.squaredNorm() <= r.squaredNorm() * kNoWorse;
        }
        result.converged = !found || std::abs(next - t) * u.norm() <= rest;
        if (!found) break;
        t = next;
        edge.curve->D2(t, c, d1, d2);
        r = there;
    }
    result.parameter = t;
    result.position = to_eigen(c);
    result.distance = r.norm();
    return result;
}

EdgePoint closest_on_edge(const CadEdge& edge, const Vector3d& p) {
    int spans = 1;
    if (const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve); !spline.IsNull())
        spans = spline->NbKnots() - 1;
    const int n = std::max(kSamples, kSamplesPerSpan * spans);
    std::vector<std::pair<double, double>> row;  // squared distance, parameter
    for (int i = 0; i <= n; ++i) {
        const double t = edge.range.low + (edge.range.high - edge.range.low) * i / n;
        row.push_back({(to_eigen(edge.curve->Value(t)) - p).squaredNorm(), t});
    }
    std::partial_sort(row.begin(), row.begin() + kStarts, row.end());
    EdgePoint best;
    best.distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kStarts; ++i) {
        const EdgePoint found = closest_on_edge(edge, p, row[static_cast<std::size_t>(i)].second);
        if (found.distance < best.distance) best = found;
    }
    return best;
}

}  // namespace anisoquad::cad
