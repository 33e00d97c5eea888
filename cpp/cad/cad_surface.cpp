#include "cad/cad_surface.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "cad/closest_point.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFar = 0.5;      ///< of the facet's longest edge: so far off, the start was wrong
constexpr double kOnTrim = 1e-7;  ///< tolerance of what is inside of a face

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

/// What a facet beside a joined edge borders on: the face over there, and the edge, each with a start.
struct CadSurface::Beyond {
    std::int32_t face = -1;
    Vector2d parameter = Vector2d::Zero();
    std::int32_t edge = -1;
    double on_edge = 0.0;
};

/// Tells inside from outside, for the faces beside joined edges.
struct CadSurface::Trims {
    std::map<std::int32_t, BRepTopAdaptor_FClass2d> of;
    bool is_inside(std::int32_t face, const Vector2d& x) const {
        const auto trim = of.find(face);
        return trim == of.end() || trim->second.Perform(gp_Pnt2d(x[0], x[1])) != TopAbs_OUT;
    }
};

CadSurface::CadSurface(std::shared_ptr<const CadShape> shape, std::shared_ptr<const MeshLink> link, Triangles triangles,
                       std::span<const char> joined)
    : shape_(std::move(shape)),
      link_(std::move(link)),
      triangles_(triangles.begin(), triangles.end()),
      on_path_(link_->paths),
      joined_(joined.begin(), joined.end()) {
    joined_.resize(shape_->edges().size(), 0);
    find_beyond();
}

CadSurface::~CadSurface() = default;

std::vector<std::array<std::int32_t, 2>> CadSurface::feature_edges() const {
    std::vector<std::array<std::int32_t, 2>> edges;
    for (std::size_t e = 0; e < joined_.size(); ++e) {
        if (joined_[e] || !shape_->edges()[e].is_border()) continue;
        const auto& path = link_->paths[e].vertices;
        for (std::size_t i = 1; i < path.size(); ++i) edges.push_back({path[i - 1], path[i]});
    }
    return edges;
}

void CadSurface::find_beyond() {
    first_beyond_.assign(triangles_.size() + 1, 0);
    auto trims = std::make_unique<Trims>();
    // The facets at each vertex of a joined edge, where the face over there is met.
    std::map<std::int32_t, std::vector<Beyond>> at_vertex;
    for (std::size_t e = 0; e < joined_.size(); ++e) {
        if (!joined_[e]) continue;
        const EdgePath& path = link_->paths[e];
        for (std::size_t i = 0; i < path.vertices.size(); ++i) {
            at_vertex[path.vertices[i]].push_back({-1, Vector2d::Zero(), static_cast<std::int32_t>(e), path.parameters[i]});
        }
        for (const std::int32_t face : shape_->edges()[e].faces) trims->of.try_emplace(face, shape_->face(face).face, kOnTrim);
    }
    std::map<std::tuple<std::int32_t, std::int32_t>, Vector2d> corner;  ///< (vertex, face) → parameters
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (at_vertex.contains(triangles_[f][k]))
                corner.try_emplace({triangles_[f][k], link_->facet_face[f]}, link_->facet_parameter[f][k]);
        }
    }
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
        for (const std::int32_t v : triangles_[f]) {
            const auto found = at_vertex.find(v);
            if (found == at_vertex.end()) continue;
            for (Beyond b : found->second) {
                for (const std::int32_t face : shape_->edge(b.edge).faces) {
                    const auto start = corner.find({v, face});
                    if (face == link_->facet_face[f] || start == corner.end()) continue;
                    b.face = face;
                    b.parameter = start->second;
                    beyond_.push_back(b);
                }
            }
        }
        first_beyond_[f + 1] = static_cast<std::int32_t>(beyond_.size());
    }
    trims_ = std::move(trims);
}

void CadSurface::project(std::span<const TargetPlace> places, std::span<Vector3d> points) const {
    for (std::size_t i = 0; i < places.size(); ++i) {
        const TargetPlace& place = places[i];
        const PathEdges::Side side = place.edge[0] >= 0 ? on_path_.find(place.edge[0], place.edge[1]) : PathEdges::Side{};
        if (side.edge < 0) {
            if (place.facet >= 0) points[i] = on_face(place, points[i]);
            continue;
        }
        points[i] = closest_on_edge(shape_->edge(side.edge), points[i],
                                    (1.0 - place.share) * side.parameter[0] + place.share * side.parameter[1])
                        .position;
    }
}

Vector3d CadSurface::on_face(const TargetPlace& place, const Vector3d& p) const {
    const auto& corner = link_->facet_parameter[at(place.facet)];
    const CadFace& face = shape_->face(link_->facet_face[at(place.facet)]);
    FacePoint found =
        closest_on_face(face, p, place.weights[0] * corner[0] + place.weights[1] * corner[1] + place.weights[2] * corner[2]);
    const auto& t = triangles_[at(place.facet)];
    const double longest = std::max({(link_->points[at(t[0])] - link_->points[at(t[1])]).norm(),
                                     (link_->points[at(t[1])] - link_->points[at(t[2])]).norm(),
                                     (link_->points[at(t[2])] - link_->points[at(t[0])]).norm()});
    if (!found.converged || found.distance > kFar * longest) {
        const FacePoint other = closest_on_face(face, p);
        if (other.distance < found.distance) found = other;
    }
    return over_joints(place.facet, p, found.position, found.parameter);
}

Vector3d CadSurface::over_joints(std::int32_t facet, const Vector3d& p, const Vector3d& found, const Vector2d& parameter) const {
    const auto first = first_beyond_[at(facet)];
    const auto last = first_beyond_[at(facet) + 1];
    if (first == last || trims_->is_inside(link_->facet_face[at(facet)], parameter)) return found;
    Vector3d best = found;
    double nearest = std::numeric_limits<double>::infinity();
    for (const bool on_faces : {true, false}) {
        for (std::int32_t i = first; i < last; ++i) {
            const Beyond& b = beyond_[at(i)];
            if (on_faces) {
                const FacePoint other = closest_on_face(shape_->face(b.face), p, b.parameter);
                if (other.distance < nearest && trims_->is_inside(b.face, other.parameter)) {
                    nearest = other.distance;
                    best = other.position;
                }
            } else {
                const EdgePoint other = closest_on_edge(shape_->edge(b.edge), p, b.on_edge);
                if (other.distance < nearest) {
                    nearest = other.distance;
                    best = other.position;
                }
            }
        }
        if (std::isfinite(nearest)) return best;
    }
    return best;
}

}  // namespace anisoquad::cad
