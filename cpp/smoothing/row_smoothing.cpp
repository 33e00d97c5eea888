#include "smoothing/row_smoothing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "smoothing/star.h"
#include "surface/surface_fit.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr double kLargestSlide = 0.25;   ///< of the way to the neighbour in the row, per move
constexpr double kSmallestSlide = 1e-3;  ///< smaller slides are not worth a move
constexpr double kSearchReach = 0.1;
constexpr double kMostLean = 0.35;  ///< offset over height up to which a column may be bent for the elements on top of the rows
constexpr double kGoodRow = 0.8;    ///< scaled Jacobian above which an element may get worse for a straighter column

/// A node of a row and its neighbours there; invalid where there is none.
struct RowNode {
    Vertex below;
    Vertex above;
    Vertex left;
    Vertex right;
};

/// The side of a quad of a row that faces the source: the source's edge, or the edge shared with the row before.
HalfEdge bottom_edge(const SurfaceMesh& mesh, Face f) {
    const FaceInfo& info = mesh.info(f);
    for (HalfEdge h : mesh.halfedges(f)) {
        if (info.row == 1) {
            if (mesh.info(SurfaceMesh::edge(h)).source) return h;
            continue;
        }
        const Face across = mesh.face(SurfaceMesh::twin(h));
        if (!across.is_valid()) continue;
        const FaceInfo& other = mesh.info(across);
        if (other.row == info.row - 1 && other.source == info.source) return h;
    }
    return {};
}

/// @returns false where the node is not on top of a quad of a row or has no neighbour in its row
bool find_row_node(const SurfaceMesh& mesh, Vertex v, RowNode& node) {
    node = {};
    for (HalfEdge out : mesh.outgoing(v)) {
        const Face f = mesh.face(out);
        if (!f.is_valid() || mesh.info(f).row == 0 || !mesh.is_quad(f)) continue;
        const HalfEdge bottom = bottom_edge(mesh, f);
        if (!bottom.is_valid()) continue;
        // b0 → b1 is the bottom, t1 → t0 the top.
        const Vertex b0 = mesh.from(bottom);
        const Vertex b1 = mesh.to(bottom);
        const Vertex t1 = mesh.to(mesh.next(bottom));
        const Vertex t0 = mesh.from(mesh.prev(bottom));
        if (v == t0) {
            node.below = b0;
            node.right = t1;
        } else if (v == t1) {
            node.below = b1;
            node.left = t0;
        } else {
            node.above = v == b0 ? t0 : t1;
        }
    }
    return node.below.is_valid() && (node.left.is_valid() || node.right.is_valid());
}

bool may_slide(const SurfaceMesh& mesh, Vertex v) {
    const VertexInfo& info = mesh.info(v);
    return info.in_row && info.kind == NodeKind::interior && !mesh.is_boundary(v);
}

/// Unit direction of the row at the node, and the shorter way to its neighbours there.
double row_direction(const SurfaceMesh& mesh, Vertex v, const RowNode& node, Vector3d& direction) {
    const Point& p = mesh.position(v);
    const Point& left = node.left.is_valid() ? mesh.position(node.left) : p;
    const Point& right = node.right.is_valid() ? mesh.position(node.right) : p;
    direction = (right - left).normalized();
    const double to_left = node.left.is_valid() ? (p - left).norm() : (right - p).norm();
    const double to_right = node.right.is_valid() ? (right - p).norm() : to_left;
    return std::min(to_left, to_right);
}

/// Offset along the row over the height of the column's edges to the nodes below and above, the larger one.
double lean(const SurfaceMesh& mesh, const RowNode& node, const Point& p, const Vector3d& direction) {
    double most = 0.0;
    for (const Vertex end : {node.below, node.above}) {
        if (!end.is_valid()) continue;
        const Vector3d edge = p - mesh.position(end);
        const double along = edge.dot(direction);
        most = std::max(most, std::abs(along) / (edge - along * direction).norm());
    }
    return most;
}

/// Brings a place near the node onto the surface.
class Settler {
  public:
    Settler(const SurfaceMesh& mesh, Vertex v, const Star& star, const ReferenceSurface* reference, std::int32_t hint)
        : star_(star), reference_(reference), facet_(hint) {
        if (!reference_) fitted_ = fit_surface(mesh, v, fit_);
    }
    Point operator()(const Point& p) {
        if (reference_) return reference_->project(p, {star_.patch(), star_.normal()}, facet_);
        return fitted_ ? point_at_target(fit_, p) : p;
    }
    std::int32_t facet() const { return facet_; }

  private:
    const Star& star_;
    const ReferenceSurface* reference_;
    std::int32_t facet_;
    SurfaceFit fit_;
    bool fitted_ = false;
};

void settle(SurfaceMesh& mesh, Vertex v, const Point& p, std::int32_t facet, std::int32_t* hint) {
    mesh.position(v) = p;
    mesh.info(v).input = -1;
    if (hint) *hint = facet;
}

/// One slide towards right angles between the row and the column.
bool straighten_column(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference, std::int32_t* hint) {
    RowNode node;
    Star star;
    if (!find_row_node(mesh, v, node) || !star.gather(mesh, v)) return false;
    Vector3d direction;
    const double reach = row_direction(mesh, v, node, direction);
    // The lower the row, the more its edge turns for the same slide: weights are the inverse heights.
    double slide = 0.0;
    double weights = 0.0;
    for (const Vertex end : {node.below, node.above}) {
        if (!end.is_valid()) continue;
        const Vector3d edge = mesh.position(end) - star.centre();
        const double weight = 1.0 / edge.norm();
        slide += weight * edge.dot(direction);
        weights += weight;
    }
    slide = std::clamp(slide / weights, -kLargestSlide * reach, kLargestSlide * reach);
    const double before = star.quality(star.centre()).worst;
    Settler place(mesh, v, star, reference, hint ? *hint : -1);
    for (int i = 0; i < 3 && std::abs(slide) > kSmallestSlide * reach; ++i, slide *= 0.5) {
        const Point p = place(star.centre() + slide * direction);
        const double worst = star.quality(p).worst;
        if (!p.allFinite() || worst < std::min(before, kGoodRow)) continue;
        settle(mesh, v, p, place.facet(), hint);
        return true;
    }
    return false;
}

}  // namespace

bool slide_in_row(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference, std::int32_t* hint) {
    RowNode node;
    Star star;
    if (!may_slide(mesh, v) || !find_row_node(mesh, v, node) || !star.gather(mesh, v)) return false;
    Vector3d direction;
    const double reach = row_direction(mesh, v, node, direction);
    double best = star.quality(star.centre()).worst;
    const double most_lean = std::max(kMostLean, lean(mesh, node, star.centre(), direction));
    double slide = 0.0;
    for (double step = 0.5 * kSearchReach * reach; step > kSmallestSlide * reach;) {
        double found = slide;
        for (const double trial : {slide - step, slide + step}) {
            if (std::abs(trial) > kSearchReach * reach ||
                lean(mesh, node, star.centre() + trial * direction, direction) > most_lean)
                continue;
            const double worst = star.quality(star.centre() + trial * direction).worst;
            if (worst > best) {
                best = worst;
                found = trial;
            }
        }
        if (found == slide) step *= 0.5;
        slide = found;
    }
    if (slide == 0.0) return false;
    Settler place(mesh, v, star, reference, hint ? *hint : -1);
    const Point p = place(star.centre() + slide * direction);
    if (!p.allFinite() || star.quality(p).worst <= star.quality(star.centre()).worst) return false;
    settle(mesh, v, p, place.facet(), hint);
    return true;
}

RowSmoothingResult smooth_rows(SurfaceMesh& mesh, const ReferenceSurface* reference, int sweeps) {
    std::vector<Vertex> nodes;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        RowNode node;
        if (!mesh.is_deleted(v) && mesh.halfedge(v).is_valid() && may_slide(mesh, v) && find_row_node(mesh, v, node))
            nodes.push_back(v);
    }
    std::vector<std::int32_t> hints(nodes.size(), -1);
    RowSmoothingResult result;
    while (result.sweeps < sweeps) {
        int moved = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) moved += straighten_column(mesh, nodes[i], reference, &hints[i]) ? 1 : 0;
        ++result.sweeps;
        result.moved += moved;
        if (moved == 0) break;
    }
    return result;
}

}  // namespace anisoquad
