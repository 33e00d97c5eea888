#include "cad/facet_parameters.h"

#include <algorithm>
#include <cmath>

#include "cad/closest_point.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFar = 0.2;    ///< of the triangle's longest edge: so far off its face a start was wrong
constexpr double kPole = 1e-7;  ///< of the shape's diagonal, for the way that the whole range of a parameter makes there

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Walk {
  public:
    Walk(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles,
         std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
         std::span<const std::int32_t> facet_face)
        : shape_(shape), points_(points), triangles_(triangles), neighbours_(neighbours), on_path_(on_path), face_(facet_face) {
        result_.corner.resize(triangles.size());
        result_.on_face.assign(points.begin(), points.end());
        result_.distance.assign(points.size(), -1.0);
    }

    FacetParameters run() {
        std::vector<char> done(triangles_.size(), 0);
        std::vector<std::int32_t> queue;
        for (std::size_t seed = 0; seed < triangles_.size(); ++seed) {
            if (done[seed]) continue;
            done[seed] = 1;
            start(static_cast<std::int32_t>(seed));
            queue.assign(1, static_cast<std::int32_t>(seed));
            for (std::size_t i = 0; i < queue.size(); ++i) {
                const std::int32_t f = queue[i];
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::int32_t across = neighbours_[at(f)][k];
                    if (across < 0 || done[at(across)] || face_[at(across)] != face_[at(f)]) continue;
                    if (on_path_.find(triangles_[at(f)][k], triangles_[at(f)][(k + 1) % 3]).edge >= 0) continue;
                    done[at(across)] = 1;
                    step(f, k, across);
                    queue.push_back(across);
                }
            }
        }
        free_poles();
        return std::move(result_);
    }

  private:
    const CadFace& face_of(std::int32_t f) const { return shape_.face(face_[at(f)]); }

    /// The middle is searched everywhere, since it lies on no seam; the corners near it.
    void start(std::int32_t f) {
        const auto& t = triangles_[at(f)];
        const FacePoint middle = closest_on_face(face_of(f), (points_[at(t[0])] + points_[at(t[1])] + points_[at(t[2])]) / 3.0);
        for (std::size_t k = 0; k < 3; ++k) settle(f, k, middle.parameter);
    }

    /// Two corners as in the triangle before, the third where its face goes on evenly.
    void step(std::int32_t f, std::size_t side, std::int32_t across) {
        const auto& from = triangles_[at(f)];
        const auto& to = triangles_[at(across)];
        const auto& known = result_.corner[at(f)];
        const std::size_t third = static_cast<std::size_t>(
            std::find_if(to.begin(), to.end(), [&](std::int32_t v) { return v != from[side] && v != from[(side + 1) % 3]; }) -
            to.begin());
        for (std::size_t k = 0; k < 3; ++k) {
            if (k != third) result_.corner[at(across)][k] = known[to[k] == from[side] ? side : (side + 1) % 3];
        }
        Vector2d near = 0.5 * (known[side] + known[(side + 1) % 3]);
        for (const std::size_t pole : {side, (side + 1) % 3}) {
            const std::size_t other = pole == side ? (side + 1) % 3 : side;
            for (Eigen::Index i = 0; i < 2; ++i) {
                if (is_free(face_of(f), known[pole], i)) near[i] = known[other][i];
            }
        }
        settle(across, third, near);
    }

    void settle(std::int32_t f, std::size_t k, const Vector2d& near) {
        const auto& t = triangles_[at(f)];
        const Vector3d& p = points_[at(t[k])];
        const double longest = std::max((points_[at(t[(k + 1) % 3])] - p).norm(), (points_[at(t[(k + 2) % 3])] - p).norm());
        FacePoint found = closest_on_face(face_of(f), p, near);
        if (found.distance > kFar * longest) {
            const FacePoint other = closest_on_face(face_of(f), p);
            if (other.distance < found.distance) found = other;
        }
        result_.corner[at(f)][k] = found.parameter;
        double& distance = result_.distance[at(t[k])];
        if (found.distance <= distance) return;
        if (distance < 0.0) result_.on_face[at(t[k])] = found.position;
        distance = found.distance;
    }

    /// True at a pole for the parameter along which nothing moves there.
    bool is_free(const CadFace& face, const Vector2d& x, Eigen::Index i) const {
        gp_Pnt p;
        gp_Vec d[2];
        face.surface->D1(x[0], x[1], p, d[0], d[1]);
        const Range& r = face.range[static_cast<std::size_t>(i)];
        return d[i].Magnitude() * (r.high - r.low) <= kPole * shape_.diagonal();
    }

    void free_poles() {
        for (std::size_t f = 0; f < triangles_.size(); ++f) {
            const CadFace& face = face_of(static_cast<std::int32_t>(f));
            for (std::size_t k = 0; k < 3; ++k) {
                Vector2d& x = result_.corner[f][k];
                for (Eigen::Index i = 0; i < 2; ++i) {
                    if (is_free(face, x, i)) x[i] = 0.5 * (result_.corner[f][(k + 1) % 3][i] + result_.corner[f][(k + 2) % 3][i]);
                }
            }
        }
    }

    const CadShape& shape_;
    std::span<const Vector3d> points_;
    Triangles triangles_;
    std::span<const std::array<std::int32_t, 3>> neighbours_;
    const PathEdges& on_path_;
    std::span<const std::int32_t> face_;
    FacetParameters result_;
};

}  // namespace

FacetParameters find_facet_parameters(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles,
                                      std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                      std::span<const std::int32_t> facet_face) {
    return Walk(shape, points, triangles, neighbours, on_path, facet_face).run();
}

}  // namespace anisoquad::cad
