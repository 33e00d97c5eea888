#include "prepare/prepare.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/euler_operators.h"
#include "prepare/remesh.h"
#include "prepare/size_field.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;
constexpr double kPoorTriangle = 0.2;   // area over that of the equilateral triangle of the same edges: about 1:9
constexpr double kPoorShare = 0.02;     // of a patch's triangles from which it is remeshed
constexpr double kLong = 4.0 / 3.0;
constexpr int kIterations = 8;

double shape(const SurfaceMesh& mesh, Face f) {
    const HalfEdge h = mesh.halfedge(f);
    const Point& a = mesh.position(mesh.from(h));
    const Point& b = mesh.position(mesh.to(h));
    const Point& c = mesh.position(mesh.to(mesh.next(h)));
    const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return 3.4641016151377544 * (b - a).cross(c - a).norm() / edges;
}

class Prepare {
  public:
    Prepare(SurfaceMesh& mesh, const SizeField& field, const ReferenceSurface& reference, std::vector<Source>& sources, Context& context)
        : mesh_(mesh), field_(field), reference_(reference), sources_(sources), context_(context) {}

    PrepareResult run() {
        result_.triangles_before = result_.triangles_after = mesh_.face_count();
        if (!choose_patches()) return result_;
        field_.assign(mesh_);
        while (split_lines()) field_.assign(mesh_);
        follow_sources();
        for (int i = 0; i < kIterations; ++i) {
            context_.report(static_cast<double>(i) / kIterations);
            field_.assign(mesh_);
            std::vector<char> zone = zone_of_patches();
            const RemeshResult r = remesh_triangles(mesh_, zone, reference_, 1);
            if (i > 2 && 50 * (r.splits + r.collapses) < mesh_.face_count()) break;
        }
        result_.triangles_after = mesh_.face_count();
        return result_;
    }

  private:
    bool choose_patches() {
        std::vector<std::int32_t> all;
        std::vector<std::int32_t> poor;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            const auto patch = static_cast<std::size_t>(mesh_.info(Face(i)).patch);
            if (patch >= all.size()) all.resize(patch + 1, 0);
            if (patch >= poor.size()) poor.resize(patch + 1, 0);
            ++all[patch];
            poor[patch] += shape(mesh_, Face(i)) < kPoorTriangle;
        }
        chosen_.assign(all.size(), 0);
        for (std::size_t p = 0; p < all.size(); ++p) {
            if (poor[p] <= kPoorShare * all[p]) continue;
            chosen_[p] = 1;
            ++result_.patches;
            result_.poor += poor[p];
        }
        return result_.patches > 0;
    }

    bool is_chosen(HalfEdge h) const {
        return !mesh_.is_boundary(h) && chosen_[static_cast<std::size_t>(mesh_.info(mesh_.face(h)).patch)] != 0;
    }

    bool split_lines() {
        bool any = false;
        const std::int32_t last = mesh_.edge_slots();
        for (std::int32_t i = 0; i < last; ++i) {
            const Edge e(i);
            if (mesh_.is_deleted(e) || mesh_.info(e).line < 0) continue;
            const HalfEdge h = M::halfedge(e);
            if (!is_chosen(h) && !is_chosen(M::twin(h))) continue;
            const double wanted = 0.5 * (mesh_.info(mesh_.from(h)).size + mesh_.info(mesh_.to(h)).size);
            if (mesh_.length(e) <= kLong * wanted) continue;
            split_edge(mesh_, e, 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h))));
            any = true;
        }
        return any;
    }

    /// Walks along the split edges of each source, which are straight between two of its old vertices.
    void follow_sources() {
        for (Source& source : sources_) {
            std::vector<std::int32_t> nodes{source.vertices.front()};
            for (std::size_t i = 1; i < source.vertices.size(); ++i) {
                const Vertex goal(source.vertices[i]);
                Vertex at(nodes.back());
                while (at != goal) {
                    const Vector3d way = (mesh_.position(goal) - mesh_.position(at)).normalized();
                    Vertex best;
                    double straightest = 0.5;
                    for (const HalfEdge h : mesh_.outgoing(at)) {
                        if (!mesh_.info(M::edge(h)).source) continue;
                        const double along = (mesh_.position(mesh_.to(h)) - mesh_.position(at)).normalized().dot(way);
                        if (along <= straightest) continue;
                        straightest = along;
                        best = mesh_.to(h);
                    }
                    if (!best.is_valid()) return;
                    at = best;
                    nodes.push_back(at.index());
                }
            }
            source.vertices = std::move(nodes);
        }
    }

    std::vector<char> zone_of_patches() const {
        std::vector<char> zone(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || mesh_.info(v).kind != NodeKind::interior) continue;
            zone[static_cast<std::size_t>(i)] = is_chosen(mesh_.halfedge(v));
        }
        // Nodes on lines: their edges into a chosen patch may be split, those into another patch end in no zone node there.
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || mesh_.info(v).kind == NodeKind::interior) continue;
            bool all = true;
            for (const HalfEdge h : mesh_.outgoing(v)) all = all && (mesh_.is_boundary(h) || is_chosen(h));
            zone[static_cast<std::size_t>(i)] = all;
        }
        return zone;
    }

    SurfaceMesh& mesh_;
    const SizeField& field_;
    const ReferenceSurface& reference_;
    std::vector<Source>& sources_;
    Context& context_;
    PrepareResult result_;
    std::vector<char> chosen_;
};

}  // namespace

PrepareResult prepare_triangles(SurfaceMesh& mesh, std::span<const Point> points,
                                std::span<const std::array<std::int32_t, 3>> triangles, const ReferenceSurface& reference,
                                std::vector<Source>& sources, Context& context) {
    const SizeField field(points, triangles, reference, {});
    return Prepare(mesh, field, reference, sources, context).run();
}

}  // namespace anisoquad
