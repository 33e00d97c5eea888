#include "cleanup/onto_tips.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "cleanup/patterns.h"
#include "cleanup/trial.h"
#include "smoothing/move_node.h"
#include "smoothing/star.h"
#include "surface/facet_tree.h"

namespace anisoquad {
namespace {

constexpr double kGood = 0.35;   ///< scaled Jacobian round a node on its tip, which the smoothing betters
constexpr double kLeast = 0.05;  ///< what will do where nothing else is possible
constexpr double kNearer = 0.9;  ///< share of the quads' distance from the surface that may be left by a new node

/// The mesh's quads as two triangles each: those of faces[i] are 2i and 2i + 1.
FacetTree halves(const SurfaceMesh& mesh, std::vector<Face>& faces) {
    std::vector<Point> points;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) points.push_back(mesh.position(Vertex(i)));
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> patch;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const Face f(i);
        if (mesh.is_deleted(f) || !mesh.is_quad(f)) continue;
        const HalfEdge h = mesh.halfedge(f);
        for (const HalfEdge half : {h, mesh.next(mesh.next(h))}) {
            triangles.push_back({mesh.from(half).index(), mesh.to(half).index(), mesh.to(mesh.next(half)).index()});
            patch.push_back(mesh.info(f).patch);
        }
        faces.push_back(f);
    }
    return {std::move(points), std::move(triangles), std::move(patch)};
}

class OntoTips {
  public:
    OntoTips(SurfaceMesh& mesh, const ReferenceSurface& reference)
        : mesh_(mesh), reference_(reference), trial_(mesh, reference), quads_(halves(mesh, faces_)) {}

    /// @returns true if a node is on the tip afterwards that was not there before
    bool put_node_on(const Tip& tip) {
        const std::int32_t half = quads_.closest(tip.place, tip.patch, -1).facet;
        if (half < 0) return false;
        const Face quad = faces_[static_cast<std::size_t>(half / 2)];
        if (mesh_.is_deleted(quad) || !mesh_.is_quad(quad)) return false;  // used up by a tip beside this one
        for (const HalfEdge h : mesh_.halfedges(quad)) {
            if (mesh_.position(mesh_.from(h)) == tip.place) return false;
        }
        return move_node_onto(tip, quad, kGood) || add_node_on(tip, quad) || move_node_onto(tip, quad, kLeast);
    }

  private:
    /// Worst quality of the faces round v with v at p; −1 where it may not move.
    double quality_at(Vertex v, const Point& p) const {
        Star star;
        if (!is_movable(mesh_, v) || !star.gather(mesh_, v)) return -1.0;
        star.see_along_surface(reference_);
        return star.quality(p).worst;
    }

    bool move_node_onto(const Tip& tip, Face quad, double least) {
        Vertex best;
        for (const HalfEdge h : mesh_.halfedges(quad)) {
            const double quality = quality_at(mesh_.from(h), tip.place);
            if (quality <= least) continue;
            least = quality;
            best = mesh_.from(h);
        }
        if (!best.is_valid()) return false;
        mesh_.position(best) = tip.place;
        hold(mesh_.info(best), tip);
        return true;
    }

    /// Three quads round the tip instead of the quad and a neighbour.
    bool add_node_on(const Tip& tip, Face quad) {
        std::vector<Proposal> proposals;
        for (const HalfEdge h : mesh_.halfedges(quad)) propose_hexagon(mesh_, mesh_.from(h), proposals);
        for (Proposal& p : proposals) {
            if (p.faces.size() != 2 || std::find(p.faces.begin(), p.faces.end(), quad) == p.faces.end()) continue;
            Replacement::Node& node = p.replacement.nodes.front();
            node.place = tip.place;
            hold(node.info, tip);
            Region region{p.faces, {}, {}};
            const Trial::Demands demands{.gain = std::numeric_limits<int>::min(), .bound = kLeast, .nearer = kNearer};
            if (trial_.attempt(region, p.replacement, demands)) return true;
        }
        return false;
    }

    static void hold(VertexInfo& info, const Tip& tip) {
        info.kind = NodeKind::corner;
        info.input = tip.input;
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    Trial trial_;
    std::vector<Face> faces_;
    FacetTree quads_;
};

}  // namespace

std::int32_t move_onto_tips(SurfaceMesh& mesh, const ReferenceSurface& reference, std::span<const Tip> tips) {
    if (tips.empty()) return 0;
    OntoTips onto(mesh, reference);
    std::int32_t count = 0;
    for (const Tip& tip : tips) count += onto.put_node_on(tip) ? 1 : 0;
    return count;
}

}  // namespace anisoquad
