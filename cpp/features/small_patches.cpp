#include "features/small_patches.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/euler_operators.h"
#include "quality/metrics.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kPoor = 0.1;  // scaled Jacobian of the quad that two triangles make

bool is_triangle(const SurfaceMesh& mesh, HalfEdge h) { return !mesh.is_boundary(h) && mesh.is_triangle(mesh.face(h)); }

/// An edge of the patch's outline that may be halved: what lies beyond is a triangle or nothing.
bool is_open_side(const SurfaceMesh& mesh, HalfEdge h) {
    return mesh.is_constrained(M::edge(h)) && (mesh.is_boundary(M::twin(h)) || is_triangle(mesh, M::twin(h)));
}

/// The half-edge between the two triangles of a patch of two; invalid if `f` is not in such a patch.
HalfEdge diagonal_of_pair(const SurfaceMesh& mesh, Face f) {
    HalfEdge diagonal;
    for (const HalfEdge h : mesh.halfedges(f)) {
        if (is_open_side(mesh, h)) continue;
        if (diagonal.is_valid() || mesh.is_constrained(M::edge(h)) || !is_triangle(mesh, M::twin(h))) return {};
        diagonal = h;
    }
    if (!diagonal.is_valid()) return {};
    const HalfEdge other = M::twin(diagonal);
    return is_open_side(mesh, mesh.next(other)) && is_open_side(mesh, mesh.prev(other)) ? diagonal : HalfEdge();
}

bool makes_poor_quad(const SurfaceMesh& mesh, HalfEdge diagonal) {
    const HalfEdge other = M::twin(diagonal);
    const auto p = [&](HalfEdge h) -> const Point& { return mesh.position(mesh.from(h)); };
    return scaled_jacobian(p(diagonal), p(mesh.prev(other)), p(other), p(mesh.prev(diagonal))) < kPoor;
}

/// One of the four triangles that are a closed surface of their own: pairs of them would lie on each other.
bool is_of_tetrahedron(const SurfaceMesh& mesh, Face f) {
    Vertex apex;
    for (const HalfEdge h : mesh.halfedges(f)) {
        const HalfEdge beyond = M::twin(h);
        if (!is_triangle(mesh, beyond) || mesh.valence(mesh.from(h)) != 3) return false;
        const Vertex opposite = mesh.to(mesh.next(beyond));
        if (apex.is_valid() && opposite != apex) return false;
        apex = opposite;
    }
    return mesh.valence(apex) == 3;
}

/// Three quads round the middle of a triangle whose three edges were halved.
void fill_halved(SurfaceMesh& mesh, const std::array<Vertex, 3>& corners) {
    std::array<HalfEdge, 6> loop;
    std::array<Vertex, 3> middles;
    Point centre = Point::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vertex a = corners[k];
        const Vertex b = corners[(k + 1) % 3];
        // The middle is the one node next to both, in a triangle between them.
        for (const HalfEdge h : mesh.outgoing(a)) {
            if (mesh.position(mesh.to(h)) == 0.5 * (mesh.position(a) + mesh.position(b)) &&
                mesh.find_halfedge(mesh.to(h), b).is_valid())
                middles[k] = mesh.to(h);
        }
        loop[2 * k] = mesh.find_halfedge(a, middles[k]);
        loop[2 * k + 1] = mesh.find_halfedge(middles[k], b);
        centre += mesh.position(a) / 3.0;
    }
    std::vector<Face> faces;
    if (!collect_region(mesh, loop, faces, 4)) return;
    const Vertex v = split_face(mesh, replace_region(mesh, loop, faces), centre);
    for (const Vertex corner : corners) dissolve_edge(mesh, M::edge(mesh.find_halfedge(v, corner)));
}

}  // namespace

std::int32_t refine_small_patches(SurfaceMesh& mesh) {
    std::vector<Edge> edges;
    std::vector<std::array<Vertex, 3>> triangles;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i)) || !mesh.is_triangle(Face(i))) continue;
        const HalfEdge h = mesh.halfedge(Face(i));
        const std::array<HalfEdge, 3> sides{h, mesh.next(h), mesh.prev(h)};
        if (!is_of_tetrahedron(mesh, Face(i)) &&
            !std::all_of(sides.begin(), sides.end(), [&](HalfEdge side) { return is_open_side(mesh, side); })) {
            const HalfEdge diagonal = diagonal_of_pair(mesh, Face(i));
            if (!diagonal.is_valid() || !makes_poor_quad(mesh, diagonal)) continue;
        }
        for (const HalfEdge side : sides) edges.push_back(M::edge(side));
        triangles.push_back({mesh.from(sides[0]), mesh.from(sides[1]), mesh.from(sides[2])});
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const Edge e : edges) {
        const HalfEdge h = M::halfedge(e);
        split_edge(mesh, e, 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    }
    for (const auto& corners : triangles) fill_halved(mesh, corners);
    return static_cast<std::int32_t>(edges.size());
}

}  // namespace anisoquad
