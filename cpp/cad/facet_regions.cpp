#include "cad/facet_regions.h"

#include <BRepGProp.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cad/closest_point.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

constexpr double kTinyFace = 1e-12;  ///< area over the squared diagonal: such a face may have no triangle
constexpr double kAgainst = 1e6;     ///< a face whose normal is against the triangle's counts as so much farther away

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Of a triangle, from vertex to vertex.
using Side = std::array<std::int32_t, 2>;

class Regions {
  public:
    Regions(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles,
            std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path, std::span<const EdgePath> paths,
            std::span<const std::int32_t> known)
        : shape_(shape),
          points_(points),
          triangles_(triangles),
          neighbours_(neighbours),
          on_path_(on_path),
          paths_(paths),
          known_(known),
          face_(triangles.size(), -1) {}

    std::vector<std::int32_t> run() {
        for (std::size_t f = 0; f < triangles_.size(); ++f) {
            if (face_[f] < 0) fill(static_cast<std::int32_t>(f));
        }
        check_all_faces();
        return std::move(face_);
    }

  private:
    void fill(std::int32_t seed) {
        std::vector<std::int32_t> region{seed};
        std::vector<Side> border;
        face_[at(seed)] = kVisited;
        for (std::size_t i = 0; i < region.size(); ++i) {
            const auto& t = triangles_[at(region[i])];
            for (std::size_t k = 0; k < 3; ++k) {
                if (is_border(t[k], t[(k + 1) % 3])) {
                    border.push_back({t[k], t[(k + 1) % 3]});
                    continue;
                }
                const std::int32_t across = neighbours_[at(region[i])][k];
                if (across < 0 || face_[at(across)] >= 0 || face_[at(across)] == kVisited) continue;
                face_[at(across)] = kVisited;
                region.push_back(across);
            }
        }
        const std::int32_t known = known_face(region);
        const std::int32_t face = known >= 0 ? known : choose(candidates(border), region, border);
        for (const std::int32_t f : region) face_[at(f)] = face;
    }

    bool is_border(std::int32_t a, std::int32_t b) const {
        const std::int32_t edge = on_path_.find(a, b).edge;
        return edge >= 0 && shape_.edge(edge).is_border();
    }

    /// That of most triangles of the region of which it is known; -1 if it is of none.
    std::int32_t known_face(const std::vector<std::int32_t>& region) const {
        std::map<std::int32_t, int> votes;
        for (const std::int32_t f : region) {
            if (!known_.empty() && known_[at(f)] >= 0) ++votes[known_[at(f)]];
        }
        std::int32_t most = -1;
        for (const auto& [face, count] : votes) {
            if (most < 0 || count > votes[most]) most = face;
        }
        return most;
    }

    /// Faces that have an edge at each of these sides; of a region without any, the faces that have no border in the mesh.
    std::vector<std::int32_t> candidates(const std::vector<Side>& border) const {
        std::vector<std::int32_t> found;
        if (!border.empty()) {
            std::map<std::int32_t, std::size_t> sides;  // of each face
            std::vector<std::int32_t> here;
            for (const auto& [a, b] : border) {
                here.clear();
                on_path_.for_each(a, b, [&](std::int32_t edge) {
                    const auto& faces = shape_.edge(edge).faces;
                    here.insert(here.end(), faces.begin(), faces.end());
                });
                std::sort(here.begin(), here.end());
                here.erase(std::unique(here.begin(), here.end()), here.end());
                for (const std::int32_t face : here) ++sides[face];
            }
            for (const auto& [face, count] : sides) {
                if (count == border.size()) found.push_back(face);
            }
            return found;
        }
        for (std::size_t i = 0; i < shape_.faces().size(); ++i) {
            const auto& own = shape_.faces()[i].edges;
            if (std::none_of(own.begin(), own.end(),
                             [&](std::int32_t e) { return shape_.edge(e).is_border() && paths_[at(e)].vertices.size() > 1; }))
                found.push_back(static_cast<std::int32_t>(i));
        }
        return found;
    }

    std::int32_t choose(const std::vector<std::int32_t>& faces, const std::vector<std::int32_t>& region,
                        const std::vector<Side>& border) const {
        if (faces.empty()) {
            throw Error(ErrorCode::shape_mismatch,
                        shape_.name() + " has no face between " +
                            (border.empty() ? std::string("no edges") : CadShape::names("Edge", edges_of(border))) +
                            ", where the mesh has triangles: they do not belong together.",
                        ElementKind::facet, region);
        }
        if (faces.size() == 1) return faces[0];
        const Vector3d middle = middle_of(largest(region));
        const Vector3d normal = area_vector(largest(region)).normalized();
        double best = std::numeric_limits<double>::infinity();
        std::int32_t chosen = faces[0];
        for (const std::int32_t face : faces) {
            const FacePoint p = closest_on_face(shape_.face(face), middle);
            const bool against = face_normal(shape_.face(face), p.parameter).dot(normal) < -0.5;
            const double distance = p.distance * (against ? kAgainst : 1.0);
            if (!(distance < best)) continue;
            best = distance;
            chosen = face;
        }
        return chosen;
    }

    std::vector<std::int32_t> edges_of(const std::vector<Side>& border) const {
        std::vector<std::int32_t> edges;
        for (const auto& [a, b] : border) edges.push_back(on_path_.find(a, b).edge);
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        return edges;
    }

    std::int32_t largest(const std::vector<std::int32_t>& region) const {
        return *std::max_element(region.begin(), region.end(), [this](std::int32_t a, std::int32_t b) {
            return area_vector(a).squaredNorm() < area_vector(b).squaredNorm();
        });
    }
    Vector3d area_vector(std::int32_t f) const {
        const auto& [a, b, c] = triangles_[at(f)];
        return (points_[at(b)] - points_[at(a)]).cross(points_[at(c)] - points_[at(a)]);
    }
    Vector3d middle_of(std::int32_t f) const {
        const auto& [a, b, c] = triangles_[at(f)];
        return (points_[at(a)] + points_[at(b)] + points_[at(c)]) / 3.0;
    }

    void check_all_faces() const {
        std::vector<char> met(shape_.faces().size(), 0);
        for (const std::int32_t face : face_) met[at(face)] = 1;
        std::vector<std::int32_t> missing;
        for (std::size_t i = 0; i < met.size(); ++i) {
            if (met[i]) continue;
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(shape_.faces()[i].face, properties);
            if (std::abs(properties.Mass()) > kTinyFace * shape_.diagonal() * shape_.diagonal())
                missing.push_back(static_cast<std::int32_t>(i));
        }
        if (missing.empty()) return;
        throw Error(ErrorCode::face_not_meshable,
                    "The mesh has no triangles on " + CadShape::names("Face", missing) + " of " + shape_.name() + ".",
                    ElementKind::cad_face, missing);
    }

    static constexpr std::int32_t kVisited = -2;

    const CadShape& shape_;
    std::span<const Vector3d> points_;
    Triangles triangles_;
    std::span<const std::array<std::int32_t, 3>> neighbours_;
    const PathEdges& on_path_;
    std::span<const EdgePath> paths_;
    std::span<const std::int32_t> known_;
    std::vector<std::int32_t> face_;
};

}  // namespace

std::vector<std::array<std::int32_t, 3>> facet_neighbours(Triangles triangles) {
    struct Side {
        std::int32_t low, high, facet, corner;
        auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]);
            sides.push_back({low, high, static_cast<std::int32_t>(f), static_cast<std::int32_t>(k)});
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<std::array<std::int32_t, 3>> neighbours(triangles.size(), {-1, -1, -1});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side& a = sides[i];
        const Side& b = sides[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        neighbours[at(a.facet)][at(a.corner)] = b.facet;
        neighbours[at(b.facet)][at(b.corner)] = a.facet;
    }
    return neighbours;
}

std::vector<std::int32_t> find_facet_faces(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles,
                                           std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                           std::span<const EdgePath> paths, std::span<const std::int32_t> known) {
    return Regions(shape, points, triangles, neighbours, on_path, paths, known).run();
}

}  // namespace anisoquad::cad
