#include "input/slivers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "input/named_edges.h"
#include "mesh/euler_operators.h"
#include "mesh/flip_check.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr double kThin = 0.02;     ///< height over the longest edge
constexpr double kShort = 0.05;    ///< shortest edge over the longest: below it the triangle may be one of a strip
constexpr double kAnyFold = -1.0;  ///< cosine between the new triangles: the sliver's normal says nothing of the old fold
constexpr std::size_t kTurnsPerSliver = 4;  ///< one may make another of its neighbour, but not for ever

double height(const Point& a, const Point& b, const Point& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() / std::sqrt(longest);
}

struct Sliver {
    double height;
    HalfEdge longest;
    Face face;

    bool operator<(const Sliver& other) const {  // std::priority_queue takes the greatest first: the thinnest
        return height != other.height ? height > other.height : face > other.face;
    }
};

/// `longest` is invalid for any other triangle.
Sliver sliver_of(const SurfaceMesh& mesh, double diagonal, Face f) {
    Sliver sliver{0.0, {}, f};
    double most = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const HalfEdge h : mesh.halfedges(f)) {
        const double length = mesh.length(h);
        least = std::min(least, length);
        if (length <= most) continue;
        most = length;
        sliver.longest = h;
    }
    if (least < kShort * most) return {0.0, {}, f};
    const HalfEdge h = sliver.longest;
    const HalfEdge next = mesh.next(h);
    sliver.height = height(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.to(next)));
    if (!(sliver.height < kSliverHeight * diagonal && sliver.height < kThin * most)) sliver.longest = {};
    return sliver;
}

/// The two triangles get thicker, and face the way that the old ones face together, as the sliver's neighbour does.
bool is_better_turned(const SurfaceMesh& mesh, HalfEdge h) {
    const HalfEdge g = M::twin(h);
    const Point& a = mesh.position(mesh.from(h));
    const Point& b = mesh.position(mesh.to(h));
    const Point& c = mesh.position(mesh.to(mesh.next(h)));
    const Point& r = mesh.position(mesh.to(mesh.next(g)));
    if (std::min(height(a, r, c), height(r, b, c)) <= std::min(height(a, b, c), height(b, a, r))) return false;
    return flip_keeps_surface(mesh, M::edge(h), kAnyFold);
}

}  // namespace

std::vector<Face> turn_slivers(SurfaceMesh& mesh, double diagonal, std::span<const Source> sources, const Options& options) {
    std::priority_queue<Sliver> waiting;
    const auto look_at = [&](Face f) {
        const Sliver sliver = sliver_of(mesh, diagonal, f);
        if (sliver.longest.is_valid()) waiting.push(sliver);
    };
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) look_at(Face(i));
    std::vector<Face> changed;
    if (waiting.empty()) return changed;
    const NamedEdges named(sources, options);
    for (std::size_t turns = kTurnsPerSliver * waiting.size(); turns > 0 && !waiting.empty();) {
        const Sliver sliver = waiting.top();
        const HalfEdge h = sliver.longest;
        waiting.pop();
        const Sliver now = sliver_of(mesh, diagonal, sliver.face);
        if (now.longest != h || now.height != sliver.height) continue;  // turned meanwhile
        if (named.contains(mesh, h) || !is_flip_ok(mesh, M::edge(h)) || !is_better_turned(mesh, h)) continue;
        flip(mesh, M::edge(h));
        --turns;
        for (const Face f : {mesh.face(h), mesh.face(M::twin(h))}) {
            changed.push_back(f);
            look_at(f);
        }
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

}  // namespace anisoquad
