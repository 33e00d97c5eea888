#include "prepare/assess.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "mesh/area_vector.h"
#include "parallel.h"
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
constexpr double kSteepChange = 0.35;      ///< change of the triangles' size per unit of way
constexpr double kSteepShare = 0.1;        ///< of a patch's edges
constexpr double kCoarseShare = 0.015;     ///< of a patch's edges
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

/// What the edges inside the patches are: bits.
using EdgeFlags = std::uint8_t;
constexpr EdgeFlags kInside = 1;
constexpr EdgeFlags kUsable = 2;  ///< its two triangles make a quad
constexpr EdgeFlags kSteep = 4;   ///< the triangles' size changes too fast along it
constexpr EdgeFlags kSharp = 8;   ///< its triangles turn too far
constexpr EdgeFlags kOff = 16;    ///< a quad's edge across it would leave the surface

class EdgeJudge {
  public:
    EdgeJudge(const SurfaceMesh& mesh, double curvature_angle, double most_sagitta)
        : mesh_(mesh),
          cosine_(std::cos(curvature_angle * std::numbers::pi / 180.0)),
          most_sagitta_(most_sagitta),
          size_(static_cast<std::size_t>(mesh.vertex_slots()), 0.0) {
        for_each(mesh.vertex_slots(), [&](std::int32_t i) {
            if (!mesh.is_deleted(Vertex(i))) size_[static_cast<std::size_t>(i)] = size_at(mesh, Vertex(i));
        });
    }

    EdgeFlags flags(Edge e) const {
        if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) return 0;
        const HalfEdge h = M::halfedge(e);
        const double from = size_[static_cast<std::size_t>(mesh_.from(h).index())];
        const double to = size_[static_cast<std::size_t>(mesh_.to(h).index())];
        const double length = mesh_.length(h);
        const Eigen::Vector3d left = doubled_area_vector(mesh_, mesh_.face(h));
        const Eigen::Vector3d right = doubled_area_vector(mesh_, mesh_.face(M::twin(h)));
        const bool is_usable = scaled_jacobian_of_pair(mesh_, h) >= kUsablePair;
        const bool is_steep = std::abs(to - from) > kSteepChange * length;
        const bool is_sharp = left.dot(right) < cosine_ * left.norm() * right.norm();
        const bool is_off = sagitta(0.5 * (from + to), length, left, right) > most_sagitta_;
        return static_cast<EdgeFlags>(kInside | (is_usable ? kUsable : 0) | (is_steep ? kSteep : 0) | (is_sharp ? kSharp : 0) |
                                      (is_off ? kOff : 0));
    }

  private:
    const SurfaceMesh& mesh_;
    double cosine_;
    double most_sagitta_;
    std::vector<double> size_;  ///< of the triangles round each vertex
};

bool is_poor(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    return triangle_shape(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.to(mesh.next(h)))) <
           kPoorShape;
}

/// Of one patch.
struct Counts {
    std::int32_t lonely = 0;  ///< triangles that make no usable quad with any neighbour
    std::int32_t edges = 0;
    std::int32_t steep = 0;
    std::int32_t sharp = 0;
    std::int32_t off = 0;
};

}  // namespace

std::vector<PatchAssessment> assess_patches(const SurfaceMesh& mesh, double curvature_angle, double most_sagitta) {
    std::vector<char> poor(static_cast<std::size_t>(mesh.face_slots()), 0);
    for_each(mesh.face_slots(), [&](std::int32_t i) {
        if (!mesh.is_deleted(Face(i))) poor[static_cast<std::size_t>(i)] = is_poor(mesh, Face(i)) ? 1 : 0;
    });
    const EdgeJudge judge(mesh, curvature_angle, most_sagitta);
    std::vector<EdgeFlags> flags(static_cast<std::size_t>(mesh.edge_slots()), 0);
    for_each(mesh.edge_slots(), [&](std::int32_t i) { flags[static_cast<std::size_t>(i)] = judge.flags(Edge(i)); });

    std::vector<PatchAssessment> patches;
    std::vector<Counts> counts;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        const auto patch = static_cast<std::size_t>(mesh.info(Face(i)).patch);
        if (patch >= patches.size()) {
            patches.resize(patch + 1);
            counts.resize(patch + 1);
        }
        ++patches[patch].triangles;
        patches[patch].poor += poor[static_cast<std::size_t>(i)];
        EdgeFlags any = 0;
        for (const HalfEdge h : mesh.halfedges(Face(i))) any |= flags[static_cast<std::size_t>(M::edge(h).index())];
        counts[patch].lonely += (any & kInside) != 0 && (any & kUsable) == 0;
    }
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        const EdgeFlags edge = flags[static_cast<std::size_t>(i)];
        if (edge == 0) continue;
        Counts& c = counts[static_cast<std::size_t>(mesh.info(mesh.face(M::halfedge(Edge(i)))).patch)];
        ++c.edges;
        c.steep += (edge & kSteep) != 0;
        c.sharp += (edge & kSharp) != 0;
        c.off += (edge & kOff) != 0;
    }
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const Counts& c = counts[p];
        const bool is_fan = patches[p].triangles > kFewTriangles && c.lonely > kLonelyShare * patches[p].triangles;
        patches[p].is_poor = patches[p].poor > kPoorShare * patches[p].triangles || is_fan;
        patches[p].poor = std::max(patches[p].poor, c.lonely);
        patches[p].is_graded = c.edges >= kFewEdges && c.steep > kSteepShare * c.edges;
        const bool turns = c.edges >= kFewEdges && c.sharp > kCoarseShare * c.edges;
        patches[p].is_coarse = curvature_angle > 0.0 && (turns || c.off > kCoarseShare * c.edges);
    }
    return patches;
}

}  // namespace anisoquad
