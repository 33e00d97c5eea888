#include "smoothing/shape_relaxation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "mesh/area_vector.h"
#include "parallel.h"
#include "quality/metrics.h"
#include "smoothing/flat_star.h"
#include "smoothing/move_node.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr int kSweeps = 30;
constexpr double kMomentum = 0.9;  ///< of the last move that goes on
constexpr double kStep = 0.9;      ///< of the way that the quads ask for
constexpr double kSquare = 0.2;    ///< of the way from a rectangle to the square of its area
constexpr int kSweepsOffSurface = 10;
constexpr int kHalves = 3;  ///< of a node's way back, before it goes back to where it was

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The rectangle nearest to a quad with the corners p0 … p3: middle ± a ± b, a along p0 → p1.
struct Rectangle {
    Point middle;
    Vector3d a;
    Vector3d b;

    Rectangle() = default;
    Rectangle(const Point& p0, const Point& p1, const Point& p2, const Point& p3) : middle(0.25 * (p0 + p1 + p2 + p3)) {
        const Vector3d x = 0.25 * (p1 + p2 - p0 - p3);
        const Vector3d y = 0.25 * (p2 + p3 - p0 - p1);
        const Vector3d up = x.cross(y);
        const double area = up.norm();
        a = x;
        b = y;
        if (!(area > 0.0)) return;
        const double length = x.norm();
        const double width = y.norm();
        // Its sides turned back by a right angle, one axis stands for the other.
        const Vector3d axis = (x / length + y.cross(up) / (width * area)).normalized();
        const double side = std::sqrt(length * width);
        a = ((1.0 - kSquare) * length + kSquare * side) * axis;
        b = ((1.0 - kSquare) * width + kSquare * side) / area * up.cross(axis);
    }

    Point corner(int i) const { return middle + (i == 1 || i == 2 ? a : Vector3d(-a)) + (i >= 2 ? b : Vector3d(-b)); }
};

class ShapeRelaxation {
  public:
    ShapeRelaxation(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context)
        : mesh_(mesh), reference_(reference), context_(context) {}

    int run() {
        find_nodes();
        if (nodes_.empty()) return 0;
        find_quads();
        velocity_.assign(nodes_.size(), Vector3d::Zero());
        hint_.assign(nodes_.size(), -1);
        for (int sweep = 1; sweep <= kSweeps; ++sweep) {
            for_each(quad_count(), context_, [&](std::int32_t q) { rectangles_[at(q)] = rectangle(quads_[at(q)]); });
            for_each(node_count(), context_, [&](std::int32_t i) { move(i); });
            if (sweep % kSweepsOffSurface == 0 || sweep == kSweeps)
                for_each(node_count(), context_, [&](std::int32_t i) { project(i); });
        }
        go_back();
        return node_count();
    }

  private:
    std::int32_t node_count() const { return static_cast<std::int32_t>(nodes_.size()); }
    std::int32_t quad_count() const { return static_cast<std::int32_t>(quads_.size()); }
    Vertex node(std::int32_t i) const { return nodes_[at(i)]; }

    /// Free nodes with flat stars of quads.
    void find_nodes() {
        start_.resize(at(mesh_.vertex_slots()));
        std::vector<Vector3d> normal(start_.size(), Vector3d::Zero());
        for_each(mesh_.vertex_slots(), context_, [&](std::int32_t i) {
            const Vertex v(i);
            start_[at(i)] = mesh_.position(v);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || !is_movable(mesh_, v)) return;
            FlatStar star;
            if (star.gather(mesh_, v) && star.has_quads_only()) normal[at(i)] = star.normal();
        });
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (normal[at(i)].isZero(0.0)) continue;
            nodes_.emplace_back(i);
            normal_.push_back(normal[at(i)]);
        }
    }

    void find_quads() {
        std::vector<std::int32_t> number(at(mesh_.face_slots()), -1);
        first_.push_back(0);
        for (const Vertex v : nodes_) {
            for (const HalfEdge h : mesh_.outgoing(v)) {
                std::int32_t& q = number[at(mesh_.face(h).index())];
                if (q < 0) {
                    q = quad_count();
                    std::size_t n = 0;
                    quads_.emplace_back();
                    for (const HalfEdge side : mesh_.halfedges(mesh_.face(h))) quads_.back()[n++] = mesh_.from(side);
                }
                const std::array<Vertex, 4>& quad = quads_[at(q)];
                corners_.push_back(4 * q + static_cast<std::int32_t>(std::find(quad.begin(), quad.end(), v) - quad.begin()));
            }
            first_.push_back(static_cast<std::int32_t>(corners_.size()));
        }
        rectangles_.resize(quads_.size());
    }

    Rectangle rectangle(const std::array<Vertex, 4>& quad) const {
        return {mesh_.position(quad[0]), mesh_.position(quad[1]), mesh_.position(quad[2]), mesh_.position(quad[3])};
    }

    void move(std::int32_t i) {
        Point& p = mesh_.position(node(i));
        Vector3d way = Vector3d::Zero();
        for (std::int32_t k = first_[at(i)]; k < first_[at(i) + 1]; ++k)
            way += rectangles_[at(corners_[at(k)] / 4)].corner(corners_[at(k)] % 4) - p;
        way *= kStep / (first_[at(i) + 1] - first_[at(i)]);
        velocity_[at(i)] = kMomentum * velocity_[at(i)] + way - way.dot(normal_[at(i)]) * normal_[at(i)];
        p += velocity_[at(i)];
    }

    /// Back onto the surface, whose normal is another one at the new place.
    void project(std::int32_t i) {
        const std::int32_t patch = mesh_.info(mesh_.face(mesh_.halfedge(node(i)))).patch;
        Point& p = mesh_.position(node(i));
        p = reference_.project(p, {patch, normal_[at(i)]}, hint_[at(i)]);
        mesh_.info(node(i)).input = -1;
        Vector3d normal = Vector3d::Zero();
        for (std::int32_t k = first_[at(i)]; k < first_[at(i) + 1]; ++k) {
            const Rectangle& r = rectangles_[at(corners_[at(k)] / 4)];
            normal += r.a.cross(r.b);
        }
        const double length = normal.norm();
        if (!(length > 0.0)) return;
        normal_[at(i)] = normal / length;
        velocity_[at(i)] -= velocity_[at(i)].dot(normal_[at(i)]) * normal_[at(i)];
    }

    /// Poor, and poorer than it was, or turned over.
    bool is_worse(const std::array<Vertex, 4>& quad) const {
        const auto now = [&](std::size_t k) -> const Point& { return mesh_.position(quad[k]); };
        const auto before = [&](std::size_t k) -> const Point& { return start_[at(quad[k].index())]; };
        const Vector3d up = (before(2) - before(0)).cross(before(3) - before(1));
        if ((now(2) - now(0)).cross(now(3) - now(1)).dot(up) <= 0.0) return true;
        const double quality = scaled_jacobian(now(0), now(1), now(2), now(3));
        return quality < Star::kPoor && quality < scaled_jacobian(before(0), before(1), before(2), before(3));
    }

    void go_back() {
        std::vector<std::int32_t> number(start_.size(), -1);  // of the free nodes
        for (std::int32_t i = 0; i < node_count(); ++i) number[at(node(i).index())] = i;
        std::vector<int> times(nodes_.size(), 0);
        std::vector<std::int32_t> due(quads_.size());
        std::iota(due.begin(), due.end(), 0);
        std::vector<std::int32_t> back;
        const auto once_each = [](std::vector<std::int32_t>& list) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        };
        while (!due.empty()) {
            context_.breathe();
            back.clear();
            for (const std::int32_t q : due) {
                if (!is_worse(quads_[at(q)])) continue;
                for (const Vertex v : quads_[at(q)]) {
                    if (mesh_.position(v) != start_[at(v.index())]) back.push_back(number[at(v.index())]);
                }
            }
            once_each(back);
            due.clear();
            for (const std::int32_t i : back) {
                Point& p = mesh_.position(node(i));
                const Point& start = start_[at(node(i).index())];
                p = ++times[at(i)] > kHalves ? start : Point(0.5 * (p + start));
                for (std::int32_t k = first_[at(i)]; k < first_[at(i) + 1]; ++k) due.push_back(corners_[at(k)] / 4);
            }
            once_each(due);
        }
    }

    SurfaceMesh& mesh_;
    const ReferenceSurface& reference_;
    const Context& context_;
    std::vector<Point> start_;  ///< per vertex slot
    std::vector<Vertex> nodes_;
    std::vector<Vector3d> normal_;  ///< per node, unit
    std::vector<Vector3d> velocity_;
    std::vector<std::int32_t> hint_;     ///< facet of the reference surface near the node
    std::vector<std::int32_t> first_;    ///< of each node in corners_, and the end
    std::vector<std::int32_t> corners_;  ///< 4 · quad + place of the node in it
    std::vector<std::array<Vertex, 4>> quads_;
    std::vector<Rectangle> rectangles_;  ///< per quad
};

}  // namespace

int relax_shapes(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context) {
    return ShapeRelaxation(mesh, reference, context).run();
}

}  // namespace anisoquad
