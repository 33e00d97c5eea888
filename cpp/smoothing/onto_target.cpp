#include "smoothing/onto_target.h"

#include <algorithm>
#include <vector>

#include "mesh/face_middle.h"
#include "quality/metrics.h"
#include "smoothing/optimisation.h"

namespace anisoquad {
namespace {

constexpr int kRounds = 5;  ///< of optimising round what was turned over

class OntoTarget {
  public:
    OntoTarget(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines)
        : mesh_(mesh), reference_(reference), lines_(lines) {}

    OntoTargetResult run() {
        const std::vector<Face> before = inverted();
        move_all();
        std::vector<Face> after = new_ones(before);
        for (int round = 0; round < kRounds && !after.empty(); ++round) {
            if (!optimise_round(after)) break;
            after = new_ones(before);
        }
        result_.inverted = static_cast<std::int32_t>(after.size());
        return result_;
    }

  private:
    void move_all() {
        std::vector<Vertex> nodes;
        std::vector<TargetPlace> places;
        std::vector<Point> points;
        std::int32_t hint = -1;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || mesh_.info(v).input >= 0) continue;
            const TargetPlace place = place_of(v, hint);
            if (place.facet < 0) continue;
            nodes.push_back(v);
            places.push_back(place);
            points.push_back(mesh_.position(v));
        }
        reference_.target().project(places, points);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            Point& p = mesh_.position(nodes[i]);
            const double move = (points[i] - p).norm();
            if (!(move > 0.0)) continue;
            result_.largest_move = std::max(result_.largest_move, move);
            ++result_.moved;
            p = points[i];
        }
    }

    TargetPlace place_of(Vertex v, std::int32_t& hint) const {
        const VertexInfo& info = mesh_.info(v);
        const HalfEdge h = mesh_.halfedge(v);
        const Face f = mesh_.face(mesh_.is_boundary(h) ? mesh_.rotated_cw(h) : h);
        TargetPlace place = reference_.place(mesh_.position(v), mesh_.info(f).patch, hint);
        if (info.line >= 0 && !lines_.empty()) {
            const ReferenceLines::EdgePlace on = lines_.closest_edge(info.line, mesh_.position(v));
            place.edge = on.edge;
            place.share = on.share;
        }
        return place;
    }

    /// In the order of the faces' slots.
    std::vector<Face> inverted() const {
        std::vector<Face> found;
        std::int32_t hint = -1;
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            const Face f(i);
            if (mesh_.is_deleted(f) || !mesh_.is_quad(f)) continue;
            const SurfacePoint below = reference_.closest(face_middle(mesh_, f), mesh_.info(f).patch, hint);
            hint = below.facet;
            if (below.facet >= 0 && scaled_jacobian(mesh_, f, below.normal) <= 0.0) found.push_back(f);
        }
        return found;
    }

    std::vector<Face> new_ones(const std::vector<Face>& before) const {
        std::vector<Face> found = inverted();
        std::erase_if(found, [&](Face f) { return std::binary_search(before.begin(), before.end(), f); });
        return found;
    }

    bool optimise_round(const std::vector<Face>& faces) {
        bool moved = false;
        for (const Face f : faces) {
            for (const HalfEdge h : mesh_.halfedges(f)) moved = optimise_node(mesh_, mesh_.from(h), &reference_) || moved;
        }
        return moved;
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    const ReferenceLines& lines_;
    OntoTargetResult result_;
};

}  // namespace

OntoTargetResult move_onto_target(SurfaceMesh& mesh, const ReferenceSurface& reference, const ReferenceLines& lines) {
    return OntoTarget(mesh, reference, lines).run();
}

}  // namespace anisoquad
