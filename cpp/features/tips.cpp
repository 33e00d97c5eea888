#include "features/tips.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mesh/area_vector.h"
#include "parallel.h"

namespace anisoquad {
namespace {

constexpr double kLeastDefect = 20.0 / 180.0 * std::numbers::pi;  ///< a cone that falls by 19 degrees from its top
constexpr double kLeastContrast = 3.0;                            ///< defect over that of any neighbour
/// Length of the common area vector of the triangles round a vertex over their area: above it no cone is as sharp. Spares the
/// angles of nearly all vertices.
constexpr double kFlat = 0.96;

/// What the angles round a vertex lack of a full turn.
double angle_defect(const SurfaceMesh& mesh, Vertex v) {
    double sum = 0.0;
    for (const HalfEdge h : mesh.outgoing(v)) {
        const Eigen::Vector3d a = mesh.position(mesh.to(h)) - mesh.position(v);
        const Eigen::Vector3d b = mesh.position(mesh.from(mesh.prev(h))) - mesh.position(v);
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return 2.0 * std::numbers::pi - sum;
}

bool is_flat(const SurfaceMesh& mesh, Vertex v) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    for (const HalfEdge h : mesh.outgoing(v)) {
        const Eigen::Vector3d of_face = doubled_area_vector(mesh, mesh.face(h));
        sum += of_face;
        area += of_face.norm();
    }
    return sum.norm() > kFlat * area;
}

bool is_off_lines(const SurfaceMesh& mesh, Vertex v) {
    return mesh.info(v).kind == NodeKind::interior && mesh.halfedge(v).is_valid() && !mesh.is_boundary(v);
}

bool is_tip(const SurfaceMesh& mesh, Vertex v) {
    if (!is_off_lines(mesh, v) || is_flat(mesh, v)) return false;
    const double defect = angle_defect(mesh, v);
    if (defect < kLeastDefect) return false;
    for (const HalfEdge h : mesh.outgoing(v)) {
        const Vertex w = mesh.to(h);
        if (is_off_lines(mesh, w) && kLeastContrast * std::abs(angle_defect(mesh, w)) > defect) return false;
    }
    return true;
}

}  // namespace

std::vector<Tip> find_tips(const SurfaceMesh& mesh) {
    std::vector<char> found(static_cast<std::size_t>(mesh.vertex_slots()), 0);
    for_each(mesh.vertex_slots(), [&](std::int32_t i) {
        found[static_cast<std::size_t>(i)] = !mesh.is_deleted(Vertex(i)) && is_tip(mesh, Vertex(i)) ? 1 : 0;
    });
    std::vector<Tip> tips;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (!found[static_cast<std::size_t>(i)]) continue;
        tips.push_back({mesh.position(v), mesh.info(mesh.face(mesh.halfedge(v))).patch, mesh.info(v).input});
    }
    return tips;
}

}  // namespace anisoquad
