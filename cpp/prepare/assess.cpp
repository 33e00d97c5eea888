#include "prepare/assess.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/area_vector.h"
#include "prepare/triangle_shape.h"
#include "quality/metrics.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

constexpr double kPoorShape = 0.2;
constexpr double kPoorShare = 0.02;        ///< of a patch's triangles
constexpr double kUsablePair = 0.35;       ///< scaled Jacobian of the quad that two triangles make
constexpr double kLonelyShare = 0.5;       ///< of a patch's triangles
constexpr std::int32_t kFewTriangles = 8;  ///< in so small patches those at the corners, or all, have no other choice
constexpr double kSteep = 0.35;            ///< change of the triangles' size per unit of way
constexpr double kSteepShare = 0.1;        ///< of a patch's edges
constexpr double kCoarseShare = 0.015;     ///< of a patch's edges
constexpr double kNoPair = -2.0;           ///< quality of the pairs of a triangle without a neighbour in its patch
constexpr std::int32_t kFewEdges = 100;    ///< fewer say nothing about a grading

double size_at(const SurfaceMesh& mesh, Vertex v) {
    double area = 0.0;
    int triangles = 0;
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (mesh.is_boundary(h)) continue;
        area += doubled_area_vector(mesh, mesh.face(h)).norm();
        ++triangles;
    }
    return triangles > 0 ? std::sqrt(area / triangles) : 0.0;
}

/// Of an edge of the given size across the edge between two triangles, whose turn happens over half of either's height.
/// @param length of their common edge; @param left, right doubled area vectors
double sagitta(double size, double length, const Eigen::Vector3d& left, const Eigen::Vector3d& right) {
    const double l = left.norm();
    const double r = right.norm();
    if (!(l > 0.0) || !(r > 0.0)) return 0.0;
    const double turn = left.cross(right).norm() / (l * r);  // small: its sine
    return 0.25 * size * size * turn * length / (l + r);
}

}  // namespace

std::vector<PatchAssessment> assess_patches(const SurfaceMesh& mesh, double curvature_angle, double most_sagitta) {
    std::vector<PatchAssessment> patches;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        const auto patch = static_cast<std::size_t>(mesh.info(Face(i)).patch);
        if (patch >= patches.size()) patches.resize(patch + 1);
        const HalfEdge h = mesh.halfedge(Face(i));
        ++patches[patch].triangles;
        patches[patch].poor += triangle_shape(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)),
                                              mesh.position(mesh.to(mesh.next(h)))) < kPoorShape;
    }
    std::vector<double> size(static_cast<std::size_t>(mesh.vertex_slots()), 0.0);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        if (!mesh.is_deleted(Vertex(i))) size[static_cast<std::size_t>(i)] = size_at(mesh, Vertex(i));
    }
    std::vector<std::int32_t> edges(patches.size(), 0);
    std::vector<std::int32_t> steep(patches.size(), 0);
    std::vector<std::int32_t> sharp(patches.size(), 0);
    std::vector<std::int32_t> off(patches.size(), 0);
    std::vector<double> best_pair(static_cast<std::size_t>(mesh.face_slots()), kNoPair);
    const double cosine = std::cos(curvature_angle * std::numbers::pi / 180.0);
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_deleted(Edge(i)) || mesh.is_constrained(Edge(i))) continue;
        const HalfEdge h = M::halfedge(Edge(i));
        const auto patch = static_cast<std::size_t>(mesh.info(mesh.face(h)).patch);
        const double from = size[static_cast<std::size_t>(mesh.from(h).index())];
        const double to = size[static_cast<std::size_t>(mesh.to(h).index())];
        const double length = mesh.length(h);
        ++edges[patch];
        steep[patch] += std::abs(to - from) > kSteep * length;
        const Eigen::Vector3d left = doubled_area_vector(mesh, mesh.face(h));
        const Eigen::Vector3d right = doubled_area_vector(mesh, mesh.face(M::twin(h)));
        sharp[patch] += left.dot(right) < cosine * left.norm() * right.norm();
        off[patch] += sagitta(0.5 * (from + to), length, left, right) > most_sagitta;
        const double pair = scaled_jacobian_of_pair(mesh, h);
        for (const Face f : {mesh.face(h), mesh.face(M::twin(h))}) {
            double& best = best_pair[static_cast<std::size_t>(f.index())];
            best = std::max(best, pair);
        }
    }
    std::vector<std::int32_t> lonely(patches.size(), 0);
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const double best = best_pair[static_cast<std::size_t>(i)];
        if (best > kNoPair && best < kUsablePair) ++lonely[static_cast<std::size_t>(mesh.info(Face(i)).patch)];
    }
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const bool is_fan = patches[p].triangles > kFewTriangles && lonely[p] > kLonelyShare * patches[p].triangles;
        patches[p].is_poor = patches[p].poor > kPoorShare * patches[p].triangles || is_fan;
        patches[p].poor = std::max(patches[p].poor, lonely[p]);
        patches[p].is_graded = edges[p] >= kFewEdges && steep[p] > kSteepShare * edges[p];
        const bool turns = edges[p] >= kFewEdges && sharp[p] > kCoarseShare * edges[p];
        patches[p].is_coarse = curvature_angle > 0.0 && (turns || off[p] > kCoarseShare * edges[p]);
    }
    return patches;
}

}  // namespace anisoquad
