#include "anisotropy/line_across.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "anisotropy/raise_sizes.h"
#include "mesh/euler_operators.h"
#include "prepare/remesh.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kThin = 0.6;      // width of the strip over the length of the source's edges
constexpr std::size_t kMost = 64;  // edges of the line that become one
constexpr double kDetour = 1.1;    // length of the line over that of the edge that stands for it
constexpr int kRounds = 4;
constexpr double kDeviation = 1e-3;  // off the surface, over its diagonal, of the triangles behind
constexpr double kUpright = 0.2;     // least cosine of a triangle's turn by a collapse

bool is_triangle_side(const SurfaceMesh& mesh, HalfEdge h) { return !mesh.is_boundary(h) && mesh.is_triangle(mesh.face(h)); }

/// The nearest node of another line that an edge joins to the i-th node, Vertex() where none is near.
Vertex node_across(const SurfaceMesh& mesh, std::span<const Vertex> nodes, std::size_t i) {
    double longest = std::numeric_limits<double>::infinity();
    HalfEdge before;
    HalfEdge after;
    if (i > 0) before = mesh.find_halfedge(nodes[i], nodes[i - 1]);
    if (i + 1 < nodes.size()) after = mesh.find_halfedge(nodes[i], nodes[i + 1]);
    for (const HalfEdge h : {before, after}) {
        if (h.is_valid()) longest = std::min(longest, kThin * mesh.length(h));
    }
    // Over the sector on the left, from the edge ahead to the one behind, or from that one back at the last node.
    const HalfEdge first = after.is_valid() ? after : before;
    if (!first.is_valid()) return {};
    Vertex found;
    for (HalfEdge h = first; is_triangle_side(mesh, after.is_valid() ? h : M::twin(h));) {
        h = after.is_valid() ? mesh.rotated_ccw(h) : mesh.rotated_cw(h);
        if (h == before || h == after) break;
        const Vertex w = mesh.to(h);
        if (mesh.info(w).line >= 0 && !mesh.info(w).in_row && mesh.length(h) < longest) {
            longest = mesh.length(h);
            found = w;
        }
        if (mesh.is_constrained(M::edge(h))) break;
    }
    return found;
}

/// The nodes of the line from a to b, both with them, in one of its directions; empty where it does not lead there.
std::vector<Vertex> way_along_line(const SurfaceMesh& mesh, HalfEdge start, Vertex b) {
    std::vector<Vertex> way{mesh.from(start)};
    for (HalfEdge h = start; way.size() <= kMost;) {
        way.push_back(mesh.to(h));
        if (way.back() == b) return way;
        if (mesh.info(way.back()).kind != NodeKind::line || mesh.info(way.back()).in_row) return {};
        HalfEdge following;
        for (const HalfEdge out : mesh.outgoing(way.back())) {
            if (mesh.is_constrained(M::edge(out)) && out != M::twin(h)) following = out;
        }
        if (!following.is_valid()) return {};
        h = following;
    }
    return {};
}

bool is_almost_straight(const SurfaceMesh& mesh, const std::vector<Vertex>& way, double sagitta) {
    const Point& a = mesh.position(way.front());
    const Vector3d chord = mesh.position(way.back()) - a;
    const double length = chord.norm();
    double along = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        along += (mesh.position(way[i]) - mesh.position(way[i - 1])).norm();
        if (chord.cross(mesh.position(way[i]) - a).norm() > sagitta * length) return false;
    }
    return along <= kDetour * length;
}

/// No triangle at the node turns over when it moves to the end of the half-edge, which leaves it.
bool stays_upright(const SurfaceMesh& mesh, HalfEdge h) {
    const Point& to = mesh.position(mesh.to(h));
    for (const HalfEdge out : mesh.outgoing(mesh.from(h))) {
        if (mesh.is_boundary(out)) continue;
        if (!mesh.is_triangle(mesh.face(out))) return false;
        const HalfEdge opposite = mesh.next(out);
        if (mesh.from(opposite) == mesh.to(h) || mesh.to(opposite) == mesh.to(h)) continue;
        const Point& p = mesh.position(mesh.from(opposite));
        const Point& q = mesh.position(mesh.to(opposite));
        const Vector3d before = (p - mesh.position(mesh.from(h))).cross(q - mesh.position(mesh.from(h)));
        const Vector3d after = (p - to).cross(q - to);
        if (!(before.dot(after) > kUpright * before.norm() * after.norm())) return false;
    }
    return true;
}

bool collapse_into(SurfaceMesh& mesh, Vertex node, Vertex neighbour) {
    const HalfEdge h = mesh.find_halfedge(node, neighbour);
    if (!h.is_valid() || !is_collapse_ok(mesh, h) || !stays_upright(mesh, h)) return false;
    collapse(mesh, h);
    return true;
}

}  // namespace

ThinnedLine thin_line_across(SurfaceMesh& mesh, std::span<const Vertex> nodes, double sagitta, std::vector<double>& length) {
    ThinnedLine result;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const Vertex a = node_across(mesh, nodes, i);
        const Vertex b = node_across(mesh, nodes, i + 1);
        if (!a.is_valid() || !b.is_valid() || a == b) continue;
        std::vector<Vertex> way;
        for (const HalfEdge out : mesh.outgoing(a)) {
            if (!mesh.is_constrained(M::edge(out))) continue;
            const std::vector<Vertex> other = way_along_line(mesh, out, b);
            if (!other.empty() && (way.empty() || other.size() < way.size())) way = other;
        }
        if (way.size() < 3 || !is_almost_straight(mesh, way, sagitta)) continue;
        // The first half to one end, the others to the other, from the ends towards the middle.
        const std::size_t half = way.size() / 2;
        int merged = 0;
        for (std::size_t k = 1; k < half && collapse_into(mesh, way[k], a); ++k) ++merged;
        for (std::size_t k = way.size() - 2; k >= half && collapse_into(mesh, way[k], b); --k) ++merged;
        result.merged += merged;
        result.failed += static_cast<int>(way.size()) - 2 - merged;
        length.resize(static_cast<std::size_t>(mesh.vertex_slots()), 0.0);
        for (const Vertex v : {a, b}) {
            double& mine = length[static_cast<std::size_t>(v.index())];
            mine = std::max(mine, (mesh.position(b) - mesh.position(a)).norm());
        }
    }
    return result;
}

void thin_lines_across(SurfaceMesh& mesh, std::vector<std::vector<Vertex>> sources, double sagitta,
                       const ReferenceSurface& reference, const Context& context) {
    for (int round = 0; round < kRounds; ++round) {
        std::vector<double> length;
        ThinnedLine all;
        for (std::vector<Vertex>& nodes : sources) {
            for (int side = 0; side < 2; ++side, std::reverse(nodes.begin(), nodes.end())) {
                const ThinnedLine one = thin_line_across(mesh, nodes, sagitta, length);
                all.merged += one.merged;
                all.failed += one.failed;
            }
        }
        if (all.merged == 0) return;
        if (all.failed > 0) {
            std::vector<char> zone = raise_sizes(mesh, length);
            remesh_triangles(mesh, zone, reference, {.deviation = kDeviation, .context = &context});
            continue;
        }
        std::vector<char> zone(static_cast<std::size_t>(mesh.vertex_slots()), 0);
        for (std::size_t i = 0; i < length.size(); ++i) {
            if (!(length[i] > 0.0)) continue;
            zone[i] = 1;
            for (const HalfEdge h : mesh.outgoing(Vertex(static_cast<std::int32_t>(i))))
                zone[static_cast<std::size_t>(mesh.to(h).index())] = 1;
        }
        swap_towards_delaunay(mesh, zone, reference, {.deviation = kDeviation});
        return;
    }
}

}  // namespace anisoquad
