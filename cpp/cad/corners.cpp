#include "cad/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cad/closest_point.h"
#include "mesh/disjoint_sets.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

constexpr double kAtVertex = 0.1;  ///< of the shortest edge at a mesh vertex: how far it may be off its CAD vertex
constexpr std::size_t kSamples = 32;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Numbers of pieces: those of the faces' vertices are one.
std::vector<std::int32_t> pieces_of(const CadShape& shape) {
    DisjointSets pieces(static_cast<std::int32_t>(shape.vertices().size()));
    for (const CadFace& face : shape.faces()) {
        std::int32_t first = -1;
        for (const std::int32_t e : face.edges) {
            for (const std::int32_t v : shape.edge(e).vertex) {
                if (first < 0) first = v;
                pieces.unite(first, v);
            }
        }
    }
    std::vector<std::int32_t> piece(shape.vertices().size());
    std::int32_t count = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const std::int32_t r = pieces.find(static_cast<std::int32_t>(i));
        piece[i] = at(r) == i ? count++ : piece[at(r)];
    }
    return piece;
}

/// The same of the mesh; -1 for vertices of no triangle.
std::vector<std::int32_t> pieces_of(std::size_t vertices, const Neighbours& neighbours) {
    std::vector<std::int32_t> piece(vertices, -1);
    std::vector<std::int32_t> reached;
    std::int32_t count = 0;
    for (std::size_t seed = 0; seed < vertices; ++seed) {
        if (piece[seed] >= 0 || neighbours.of(static_cast<std::int32_t>(seed)).empty()) continue;
        piece[seed] = count;
        reached.assign(1, static_cast<std::int32_t>(seed));
        while (!reached.empty()) {
            const std::int32_t v = reached.back();
            reached.pop_back();
            for (const std::int32_t w : neighbours.of(v)) {
                if (piece[at(w)] >= 0) continue;
                piece[at(w)] = count;
                reached.push_back(w);
            }
        }
        ++count;
    }
    return piece;
}

std::int32_t count_of(const std::vector<std::int32_t>& pieces) {
    return pieces.empty() ? 0 : *std::max_element(pieces.begin(), pieces.end()) + 1;
}

class Finder {
  public:
    Finder(const CadShape& shape, std::span<const Vector3d> points, const Neighbours& neighbours)
        : shape_(shape),
          points_(points),
          mesh_piece_(pieces_of(points.size(), neighbours)),
          shape_piece_(pieces_of(shape)),
          reach_(points.size(), 0.0) {
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (mesh_piece_[v] < 0) continue;
            double shortest = std::numeric_limits<double>::infinity();
            for (const std::int32_t w : neighbours.of(static_cast<std::int32_t>(v)))
                shortest = std::min(shortest, (points[at(w)] - points[v]).norm());
            reach_[v] = std::max(kRounding * shape.diagonal(), kAtVertex * shortest);
            longest_reach_ = std::max(longest_reach_, reach_[v]);
            along_x_.push_back(static_cast<std::int32_t>(v));
        }
        std::sort(along_x_.begin(), along_x_.end(), [&](std::int32_t a, std::int32_t b) {
            return std::pair(points[at(a)].x(), a) < std::pair(points[at(b)].x(), b);
        });
    }

    std::vector<std::int32_t> run() const {
        const std::vector<std::int32_t> mate = pair_pieces();
        std::vector<std::int32_t> corner;
        for (std::size_t i = 0; i < shape_.vertices().size(); ++i)
            corner.push_back(nearest(shape_.vertices()[i], mate[at(shape_piece_[i])]));
        return corner;
    }

  private:
    /// Calls visit(vertex, distance) for the mesh vertices that can be at the place.
    template <class Visit>
    void for_each_near(const Vector3d& place, const Visit& visit) const {
        auto v = std::lower_bound(along_x_.begin(), along_x_.end(), place.x() - longest_reach_,
                                  [&](std::int32_t a, double x) { return points_[at(a)].x() < x; });
        for (; v != along_x_.end() && points_[at(*v)].x() <= place.x() + longest_reach_; ++v)
            visit(*v, (points_[at(*v)] - place).norm());
    }

    /// @param piece of the mesh, -1 = any
    std::int32_t nearest(const Vector3d& place, std::int32_t piece) const {
        double best = std::numeric_limits<double>::infinity();
        std::int32_t found = -1;
        for_each_near(place, [&](std::int32_t v, double distance) {
            if ((piece >= 0 && mesh_piece_[at(v)] != piece) || std::pair(distance, v) >= std::pair(best, found)) return;
            best = distance;
            found = v;
        });
        return found >= 0 && best <= reach_[at(found)] ? found : -1;
    }

    /// For each piece of the shape that of the mesh, -1 where any will do. One that has all its vertices among those of another
    /// (a pin that fills a hole, the two sides of a cowl) fits both pieces of the mesh: of them it takes the nearest.
    std::vector<std::int32_t> pair_pieces() const {
        const std::int32_t pieces = count_of(shape_piece_);
        std::vector<std::int32_t> mate(at(pieces), -1);
        const std::int32_t mesh_pieces = count_of(mesh_piece_);
        if (pieces <= 1 || mesh_pieces <= 1) return mate;
        std::vector<std::pair<std::int32_t, std::int32_t>> met;  // piece of the shape, of the mesh
        std::vector<int> size(at(pieces), 0);
        std::vector<std::int32_t> here;
        for (std::size_t i = 0; i < shape_piece_.size(); ++i) {
            ++size[at(shape_piece_[i])];
            here.clear();
            for_each_near(shape_.vertices()[i], [&](std::int32_t v, double distance) {
                if (distance <= reach_[at(v)]) here.push_back(mesh_piece_[at(v)]);
            });
            std::sort(here.begin(), here.end());
            here.erase(std::unique(here.begin(), here.end()), here.end());
            for (const std::int32_t piece : here) met.emplace_back(shape_piece_[i], piece);
        }
        std::sort(met.begin(), met.end());
        std::vector<std::int32_t> order(at(pieces));
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return size[at(a)] > size[at(b)]; });
        std::vector<char> taken(at(mesh_pieces), 0);
        std::vector<std::int32_t> fitting;
        for (const std::int32_t piece : order) {
            fitting.clear();
            auto [first, last] = std::equal_range(met.begin(), met.end(), std::pair(piece, 0),
                                                  [](const auto& a, const auto& b) { return a.first < b.first; });
            for (auto next = first; first != last; first = next) {
                next = std::upper_bound(first, last, *first);
                if (next - first == size[at(piece)] && !taken[at(first->second)]) fitting.push_back(first->second);
            }
            if (fitting.empty()) continue;
            const std::int32_t mine = fitting.size() > 1 ? nearest_piece(piece, fitting) : fitting[0];
            mate[at(piece)] = mine;
            taken[at(mine)] = 1;
        }
        return mate;
    }

    /// The piece of the mesh some of whose vertices are nearest to the faces of the shape's piece.
    std::int32_t nearest_piece(std::int32_t piece, const std::vector<std::int32_t>& of) const {
        double best = std::numeric_limits<double>::infinity();
        std::int32_t found = of[0];
        for (const std::int32_t candidate : of) {
            double sum = 0.0;
            for (const std::int32_t v : samples(candidate)) sum += distance(piece, points_[at(v)]);
            if (!(sum < best)) continue;
            best = sum;
            found = candidate;
        }
        return found;
    }

    /// A few vertices of a piece of the mesh, spread over it.
    std::vector<std::int32_t> samples(std::int32_t mesh_piece) const {
        std::vector<std::int32_t> all;
        for (std::size_t v = 0; v < mesh_piece_.size(); ++v) {
            if (mesh_piece_[v] == mesh_piece) all.push_back(static_cast<std::int32_t>(v));
        }
        const std::size_t step = std::max<std::size_t>(1, all.size() / kSamples);
        std::vector<std::int32_t> some;
        for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
        return some;
    }

    /// Of a point from the faces of a piece of the shape.
    double distance(std::int32_t piece, const Vector3d& p) const {
        double least = std::numeric_limits<double>::infinity();
        for (const CadFace& face : shape_.faces()) {
            if (face.edges.empty() || shape_piece_[at(shape_.edge(face.edges[0]).vertex[0])] != piece) continue;
            least = std::min(least, closest_on_face(face, p).distance);
        }
        return least;
    }

    const CadShape& shape_;
    std::span<const Vector3d> points_;
    std::vector<std::int32_t> mesh_piece_;
    std::vector<std::int32_t> shape_piece_;  ///< per CAD vertex
    std::vector<double> reach_;              ///< how far each mesh vertex may be off a CAD vertex
    double longest_reach_ = 0.0;
    std::vector<std::int32_t> along_x_;  ///< vertices by their x
};

}  // namespace

std::vector<std::int32_t> find_corners(const CadShape& shape, std::span<const Vector3d> points, const Neighbours& neighbours) {
    return Finder(shape, points, neighbours).run();
}

}  // namespace anisoquad::cad
