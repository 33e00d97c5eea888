#include "qmorph/quad_formation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "mesh/area_vector.h"
#include "mesh/euler_operators.h"
#include "quality/metrics.h"
#include "smoothing/front_node.h"
#include "smoothing/laplacian.h"
#include "smoothing/move_node.h"

namespace anisoquad {

using M = SurfaceMesh;

constexpr double kFlat = 0.5;  // length of the triangles' common area vector over their area: below it no quad can stand for them

Face form_quad(SurfaceMesh& mesh, HalfEdge h, Vertex c, Vertex d, double least) {
    const Vertex a = mesh.from(h);
    const Vertex b = mesh.to(h);
    const std::array<HalfEdge, 4> loop{h, mesh.find_halfedge(b, c), mesh.find_halfedge(c, d), mesh.find_halfedge(d, a)};
    for (const HalfEdge side : loop) {
        if (!side.is_valid() || !mesh.face(side).is_valid()) return {};
    }
    if (mesh.has_face_on(a, b, c, d)) return {};
    static thread_local std::vector<Face> faces;
    if (!collect_region(mesh, loop, faces)) return {};
    const Eigen::Vector3d normal = doubled_area_vector(mesh, faces);
    double area = 0.0;
    for (const Face f : faces) area += doubled_area_vector(mesh, f).norm();
    if (normal.norm() < kFlat * area) return {};
    if (scaled_jacobian(mesh.position(a), mesh.position(b), mesh.position(c), mesh.position(d), normal) < least) return {};
    return replace_region(mesh, loop, faces);
}

namespace {

constexpr int kMostEdges =
    32;  ///< of a node whose neighbours are smoothed: those of a fan's hub would take longer than all others together

void smooth_node(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference, FacetHints& hints) {
    if (!is_movable(mesh, v)) return;
    bool on_quad = false;
    bool on_triangle = false;
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (mesh.is_boundary(h)) continue;
        (mesh.is_triangle(mesh.face(h)) ? on_triangle : on_quad) = true;
    }
    Point target;
    if (!(on_quad && on_triangle ? front_node_target(mesh, v, target) : laplacian_target(mesh, v, target))) return;
    std::int32_t& hint = hints.of(v, mesh.vertex_slots());
    move_node(mesh, v, target, reference, &hint);
    hints.set_last(hint);
}

}  // namespace

void smooth_around(SurfaceMesh& mesh, Face quad, const ReferenceSurface* reference, FacetHints& hints) {
    static thread_local std::vector<Vertex> ring;
    ring.clear();
    std::array<Vertex, 4> nodes;
    std::size_t n = 0;
    for (const HalfEdge h : mesh.halfedges(quad)) nodes[n++] = mesh.from(h);
    for (const Vertex v : nodes) {
        if (mesh.valence(v) > kMostEdges) continue;
        for (const HalfEdge h : mesh.outgoing(v)) {
            const Vertex w = mesh.to(h);
            if (std::find(nodes.begin(), nodes.end(), w) == nodes.end() && std::find(ring.begin(), ring.end(), w) == ring.end()) {
                ring.push_back(w);
            }
        }
    }
    for (const Vertex v : nodes) smooth_node(mesh, v, reference, hints);
    for (const Vertex v : ring) smooth_node(mesh, v, reference, hints);
    for (const Vertex v : nodes) smooth_node(mesh, v, reference, hints);
}

}  // namespace anisoquad
