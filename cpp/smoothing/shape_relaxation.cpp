#include "smoothing/shape_relaxation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "mesh/z_curve.h"
#include "parallel.h"
#include "quality/metrics.h"
#include "smoothing/flat_star.h"
#include "smoothing/move_node.h"
#include "smoothing/star.h"

namespace anisoquad {
namespace {

using Eigen::Vector3d;

constexpr int kRounds = 3;         ///< after each of which the nodes are brought back onto the surface
constexpr int kSweeps = 10;        ///< of a round
constexpr double kMomentum = 0.9;  ///< of the last move that goes on
constexpr double kStep = 0.9;      ///< of the way that the quads ask for
constexpr double kSquare = 0.2;    ///< of the way from a rectangle to the square of its area
constexpr int kHalves = 3;         ///< of a node's way back, before it goes back to where it was

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

using Corners = std::array<Point, 4>;

/// Corners of the rectangle nearest to a quad.
Corners rectangle(const Corners& p) {
    const Point middle = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    Vector3d a = 0.25 * (p[1] + p[2] - p[0] - p[3]);
    Vector3d b = 0.25 * (p[2] + p[3] - p[0] - p[1]);
    const Vector3d up = a.cross(b);
    const double area = up.norm();
    if (area > 0.0) {
        const double length = a.norm();
        const double width = b.norm();
        // Turned back by a right angle, one axis stands for the other.
        const Vector3d axis = (a / length + b.cross(up) / (width * area)).normalized();
        const double side = std::sqrt(length * width);
        a = ((1.0 - kSquare) * length + kSquare * side) * axis;
        b = ((1.0 - kSquare) * width + kSquare * side) / area * up.cross(axis);
    }
    return {middle - a - b, middle + a - b, middle + a + b, middle - a + b};
}

class ShapeRelaxation {
  public:
    ShapeRelaxation(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context)
        : mesh_(mesh), reference_(reference), context_(context) {}

    int run() {
        find_free_nodes();
        if (free_ == 0) return 0;
        find_quads();
        velocity_.assign(at(free_), Vector3d::Zero());
        hint_.assign(at(free_), -1);
        for (int round = 0; round < kRounds; ++round) {
            for (int sweep = 0; sweep < kSweeps; ++sweep) {
                for_each(quad_count(), context_, [&](std::int32_t q) { ask(q); });
                for_each(free_, context_, [&](std::int32_t i) { move(i); });
            }
            for_each(free_, context_, [&](std::int32_t i) { turn_normal(i); });
            for_blocks(free_, context_, [&](std::int32_t first, std::int32_t last) { project(first, last); });
        }
        go_back();
        for (std::int32_t i = 0; i < free_; ++i) {
            mesh_.position(node_[at(i)]) = position_[at(i)];
            mesh_.info(node_[at(i)]).input = -1;
        }
        return free_;
    }

  private:
    /// Its nodes, and where what it asks of each of them stands in asked_; −1 where the node is not free.
    struct Quad {
        std::array<std::int32_t, 4> node;
        std::array<std::int32_t, 4> place{-1, -1, -1, -1};
    };

    std::int32_t quad_count() const { return static_cast<std::int32_t>(quads_.size()); }
    Corners now(const Quad& q) const {
        return {position_[at(q.node[0])], position_[at(q.node[1])], position_[at(q.node[2])], position_[at(q.node[3])]};
    }
    const Point& before(std::int32_t i) const { return mesh_.position(node_[at(i)]); }

    /// Nodes with flat stars of quads, so that what is near each other on the surface is so in memory.
    void find_free_nodes() {
        std::vector<Vector3d> normal(at(mesh_.vertex_slots()), Vector3d::Zero());
        for_each(mesh_.vertex_slots(), context_, [&](std::int32_t i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v) || !mesh_.halfedge(v).is_valid() || !is_movable(mesh_, v)) return;
            FlatStar star;
            if (star.gather(mesh_, v) && star.has_quads_only()) normal[at(i)] = star.normal();
        });
        std::vector<Vertex> nodes;
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            if (!normal[at(i)].isZero(0.0)) nodes.emplace_back(i);
        }
        free_ = static_cast<std::int32_t>(nodes.size());
        for (const std::int32_t i :
             order_along_z_curve(free_, [&](std::int32_t k) -> Point { return mesh_.position(nodes[at(k)]); })) {
            node_.push_back(nodes[at(i)]);
            normal_.push_back(normal[at(nodes[at(i)].index())]);
        }
    }

    /// The quads round the free nodes, and the nodes beside these.
    void find_quads() {
        std::vector<std::int32_t> number(at(mesh_.vertex_slots()), -1);
        for (std::int32_t i = 0; i < free_; ++i) number[at(node_[at(i)].index())] = i;
        const auto number_of = [&](Vertex v) {
            std::int32_t& i = number[at(v.index())];
            if (i < 0) {
                i = static_cast<std::int32_t>(node_.size());
                node_.push_back(v);
            }
            return i;
        };
        std::vector<std::int32_t> quad_of_face(at(mesh_.face_slots()), -1);
        first_.push_back(0);
        for (std::int32_t i = 0; i < free_; ++i) {
            for (const HalfEdge h : mesh_.outgoing(node_[at(i)])) {
                std::int32_t& q = quad_of_face[at(mesh_.face(h).index())];
                if (q < 0) {
                    q = quad_count();
                    quads_.emplace_back();
                    std::size_t n = 0;
                    for (const HalfEdge side : mesh_.halfedges(mesh_.face(h)))
                        quads_.back().node[n++] = number_of(mesh_.from(side));
                }
                Quad& quad = quads_[at(q)];
                const auto corner = std::find(quad.node.begin(), quad.node.end(), i) - quad.node.begin();
                quad.place[static_cast<std::size_t>(corner)] = static_cast<std::int32_t>(quad_round_.size());
                quad_round_.push_back(q);
            }
            first_.push_back(static_cast<std::int32_t>(quad_round_.size()));
        }
        asked_.resize(quad_round_.size());
        for (const Vertex v : node_) position_.push_back(mesh_.position(v));
    }

    void ask(std::int32_t q) {
        const Quad& quad = quads_[at(q)];
        const Corners corners = rectangle(now(quad));
        for (std::size_t k = 0; k < 4; ++k) {
            if (quad.place[k] >= 0) asked_[at(quad.place[k])] = corners[k];
        }
    }

    void move(std::int32_t i) {
        Vector3d sum = Vector3d::Zero();
        for (std::int32_t k = first_[at(i)]; k < first_[at(i) + 1]; ++k) sum += asked_[at(k)];
        const Vector3d way = sum / (first_[at(i) + 1] - first_[at(i)]) - position_[at(i)];
        velocity_[at(i)] = kMomentum * velocity_[at(i)] + kStep * (way - way.dot(normal_[at(i)]) * normal_[at(i)]);
        position_[at(i)] += velocity_[at(i)];
    }

    /// Normals of the quads as they lie now.
    void turn_normal(std::int32_t i) {
        Vector3d area = Vector3d::Zero();
        for (std::int32_t k = first_[at(i)]; k < first_[at(i) + 1]; ++k) {
            const Corners p = now(quads_[at(quad_round_[at(k)])]);
            area += (p[2] - p[0]).cross(p[3] - p[1]);
        }
        const double length = area.norm();
        if (length > 0.0) normal_[at(i)] = area / length;
    }

    void project(std::int32_t first, std::int32_t last) {
        std::int32_t hint = -1;  // the node before is near
        for (std::int32_t i = first; i < last; ++i) {
            const std::int32_t patch = mesh_.info(mesh_.face(mesh_.halfedge(node_[at(i)]))).patch;
            if (hint_[at(i)] < 0) hint_[at(i)] = hint;
            position_[at(i)] = reference_.project(position_[at(i)], {patch, normal_[at(i)]}, hint_[at(i)]);
            velocity_[at(i)] -= velocity_[at(i)].dot(normal_[at(i)]) * normal_[at(i)];
            hint = hint_[at(i)];
        }
    }

    /// Poor, and poorer than it was, or turned over.
    bool is_worse(const Quad& quad) const {
        const auto [a, b, c, d] = now(quad);
        const Point& a0 = before(quad.node[0]);
        const Point& b0 = before(quad.node[1]);
        const Point& c0 = before(quad.node[2]);
        const Point& d0 = before(quad.node[3]);
        if ((c - a).cross(d - b).dot((c0 - a0).cross(d0 - b0)) <= 0.0) return true;
        const double quality = scaled_jacobian(a, b, c, d);
        return quality < Star::kPoor && quality < scaled_jacobian(a0, b0, c0, d0);
    }

    void go_back() {
        std::vector<int> times(at(free_), 0);
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
                for (const std::int32_t i : quads_[at(q)].node) {
                    if (i < free_ && position_[at(i)] != before(i)) back.push_back(i);
                }
            }
            once_each(back);
            due.clear();
            for (const std::int32_t i : back) {
                Point& p = position_[at(i)];
                p = ++times[at(i)] > kHalves ? before(i) : Point(0.5 * (p + before(i)));
                due.insert(due.end(), quad_round_.begin() + first_[at(i)], quad_round_.begin() + first_[at(i) + 1]);
            }
            once_each(due);
        }
    }

    SurfaceMesh& mesh_;  ///< whose nodes stay where they are until the end
    const ReferenceSurface& reference_;
    const Context& context_;
    std::int32_t free_ = 0;
    std::vector<Vertex> node_;  ///< the free ones, then those beside them
    std::vector<Point> position_;
    std::vector<Vector3d> normal_;          ///< of the free ones, unit
    std::vector<Vector3d> velocity_;        ///< way of the last sweep
    std::vector<std::int32_t> hint_;        ///< facet of the reference surface near the node
    std::vector<std::int32_t> first_;       ///< of each free node in quad_round_, and the end
    std::vector<std::int32_t> quad_round_;  ///< quads round the nodes
    std::vector<Point> asked_;              ///< of the node by each of them: where to come
    std::vector<Quad> quads_;
};

}  // namespace

int relax_shapes(SurfaceMesh& mesh, const ReferenceSurface& reference, const Context& context) {
    return ShapeRelaxation(mesh, reference, context).run();
}

}  // namespace anisoquad
