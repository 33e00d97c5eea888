#include "qmorph/closure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "mesh/area_vector.h"
#include "mesh/euler_operators.h"
#include "qmorph/front.h"
#include "quality/metrics.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Eigen::Vector3d;

constexpr double kFlat = 0.5;      // length of a region's area vector over its area: below it no few quads can stand for it
constexpr double kFolded = -0.3;   // what smoothing can still open
constexpr double kPlane = 0.9;     // flatness of a region in which it can open any quad whose nodes are free
constexpr double kDoubled = -2.0;  // a cut that would double an edge
constexpr int kMostTries = 50;     // of the ways of a single triangle to another one

/// Length of the region's area vector over its area. Small for what only its loop is small of: all of a closed surface but one
/// quad.
double flatness(const SurfaceMesh& mesh, const std::vector<Face>& faces) {
    double area = 0.0;
    for (const Face f : faces) area += doubled_area_vector(mesh, f).norm();
    return area > 0.0 ? doubled_area_vector(mesh, faces).norm() / area : 0.0;
}

/// Six edges: cut by one of three diagonals into two quads, or three spokes from a new node to every other node.
bool close_six(SurfaceMesh& mesh, const std::array<HalfEdge, 6>& loop, const std::vector<Face>& faces) {
    std::array<Vertex, 6> v;
    for (std::size_t i = 0; i < 6; ++i) v[i] = mesh.from(loop[i]);
    const auto p = [&](std::size_t i) -> const Point& { return mesh.position(v[i % 6]); };
    const Vector3d n = doubled_area_vector(mesh, faces);
    double best = kFolded;
    int choice = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        if (mesh.find_halfedge(v[i], v[i + 3]).is_valid() && std::none_of(faces.begin(), faces.end(), [&](Face f) {
                const HalfEdge d = mesh.find_halfedge(v[i], v[i + 3]);
                return mesh.face(d) == f || mesh.face(M::twin(d)) == f;
            })) {
            continue;  // joined outside already: a second edge between the same nodes
        }
        if (mesh.has_face_on(v[i], v[i + 1], v[i + 2], v[i + 3]) ||
            mesh.has_face_on(v[i + 3], v[(i + 4) % 6], v[(i + 5) % 6], v[i]))
            continue;
        const double q = std::min(scaled_jacobian(p(i), p(i + 1), p(i + 2), p(i + 3), n),
                                  scaled_jacobian(p(i + 3), p(i + 4), p(i + 5), p(i), n));
        if (q > best) {
            best = q;
            choice = static_cast<int>(i);
        }
    }
    Point centre = Point::Zero();
    for (std::size_t i = 0; i < 6; ++i) centre += p(i) / 6.0;
    for (std::size_t i = 0; i < 2; ++i) {
        double q = 1.0;
        for (std::size_t k = i; k < 6; k += 2) q = std::min(q, scaled_jacobian(p(k), p(k + 1), p(k + 2), centre, n));
        if (q > best) {
            best = q;
            choice = 3 + static_cast<int>(i);
        }
    }
    if (choice < 0) return false;
    replace_region(mesh, loop, faces);
    if (choice < 3) {
        const auto i = static_cast<std::size_t>(choice);
        insert_edge(mesh, loop[i], loop[i + 3]);
        return true;
    }
    const auto i = static_cast<std::size_t>(choice - 3);
    // A star of six spokes, of which every other one goes.
    const Vertex c = split_face(mesh, mesh.face(loop[0]), centre);
    for (std::size_t k = i + 1; k < i + 7; k += 2) dissolve_edge(mesh, M::edge(mesh.find_halfedge(c, v[k % 6])));
    return true;
}

/// The unmeshed triangles of the patch, and the walk of single triangles towards each other.
class Finish {
  public:
    explicit Finish(SurfaceMesh& mesh) : mesh_(mesh) {}

    FinishResult run() {
        pair_neighbours();
        collect_single();
        for (Face f : single_) {
            if (mesh_.is_deleted(f) || !mesh_.is_triangle(f)) continue;
            if (walk(f, false) || walk(f, true)) ++result_.walks;
        }
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i)
            result_.left += !mesh_.is_deleted(Face(i)) && mesh_.is_triangle(Face(i));
        return result_;
    }

  private:
    struct Pair {
        double quality;
        Edge edge;
    };

    bool joins_triangles(Edge e) const {
        if (mesh_.is_deleted(e) || mesh_.is_constrained(e)) return false;
        const HalfEdge h = M::halfedge(e);
        const HalfEdge g = M::twin(h);
        if (!mesh_.is_triangle(mesh_.face(h)) || !mesh_.is_triangle(mesh_.face(g))) return false;
        const Vertex c = mesh_.to(mesh_.next(h));
        const Vertex d = mesh_.to(mesh_.next(g));
        return c != d &&
               !mesh_.has_face_on(mesh_.from(h), mesh_.to(h), c, d);  // neither two triangles on the same nodes nor a copy
    }

    void pair_neighbours() {
        std::vector<Pair> pairs;
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) {
            if (joins_triangles(Edge(i))) pairs.push_back({scaled_jacobian_of_pair(mesh_, M::halfedge(Edge(i))), Edge(i)});
        }
        std::sort(pairs.begin(), pairs.end(),
                  [](const Pair& a, const Pair& b) { return a.quality != b.quality ? a.quality > b.quality : a.edge < b.edge; });
        for (const Pair& pair : pairs) {
            if (!joins_triangles(pair.edge)) continue;
            dissolve_edge(mesh_, pair.edge);
            ++result_.pairs;
        }
    }

    void collect_single() {
        for (std::int32_t i = 0; i < mesh_.face_slots(); ++i) {
            if (!mesh_.is_deleted(Face(i)) && mesh_.is_triangle(Face(i))) single_.push_back(Face(i));
        }
    }

    /// Breadth-first to the nearest other triangle; then cut the pentagons along the way anew. A door that can not be passed is
    /// remembered and the way searched again.
    /// @param f the triangle; receives where it has come to if it meets no other
    /// @param with_nodes pentagons that no diagonal can cut get a new node inside
    bool walk(Face& f, bool with_nodes) {
        shut_.clear();
        for (int tries = 0; tries < kMostTries; ++tries) {
            if (!find_path(f)) return false;
            bool passed = true;
            for (std::size_t i = 0; i + 1 < path_.size() && passed; ++i) {
                passed = step(path_[i], path_[i + 1], with_nodes);
                if (!passed) {
                    f = mesh_.face(path_[i]);
                    if (!absorb(f, path_[i])) shut_.push_back(M::edge(path_[i]));
                }
            }
            if (!passed) continue;
            const Edge last = M::edge(path_.back());
            if (joins_triangles(last)) {
                dissolve_edge(mesh_, last);
                return true;
            }
            f = mesh_.face(path_.back());
            shut_.push_back(last);
        }
        return false;
    }

    bool find_path(Face start) {
        queue_.assign(1, start);
        from_.resize(static_cast<std::size_t>(mesh_.face_slots()));
        stamp_.resize(static_cast<std::size_t>(mesh_.face_slots()), -1);
        ++now_;
        stamp_[static_cast<std::size_t>(start.index())] = now_;
        Face goal;
        for (std::size_t i = 0; i < queue_.size() && !goal.is_valid(); ++i) {
            for (const HalfEdge h : mesh_.halfedges(queue_[i])) {
                if (mesh_.is_constrained(M::edge(h)) || std::find(shut_.begin(), shut_.end(), M::edge(h)) != shut_.end())
                    continue;
                const Face g = mesh_.face(M::twin(h));
                const auto slot = static_cast<std::size_t>(g.index());
                if (stamp_[slot] == now_ || mesh_.info(g).row > 0) continue;
                stamp_[slot] = now_;
                from_[slot] = h;  // the half-edge, in the face before, that is crossed
                queue_.push_back(g);
                if (mesh_.is_triangle(g)) {
                    goal = g;
                    break;
                }
            }
        }
        if (!goal.is_valid()) return false;
        path_.clear();
        for (Face f = goal; f != start; f = mesh_.face(path_.back())) path_.push_back(from_[static_cast<std::size_t>(f.index())]);
        std::reverse(path_.begin(), path_.end());
        return true;
    }

    /// A triangle and a quad that share two edges are the triangle without the node between these.
    /// @param f the triangle of `door`; receives what it becomes; @returns false, and nothing changed, if they are not so
    bool absorb(Face& f, HalfEdge door) {
        const HalfEdge across = M::twin(door);
        const HalfEdge left = mesh_.prev(door);   // shares from(door)
        const HalfEdge right = mesh_.next(door);  // shares to(door)
        std::array<HalfEdge, 3> loop;
        Vertex between;
        if (M::twin(left) == mesh_.next(across)) {
            between = mesh_.from(door);
            loop = {right, mesh_.next(mesh_.next(across)), mesh_.prev(across)};
        } else if (M::twin(right) == mesh_.prev(across)) {
            between = mesh_.to(door);
            loop = {left, mesh_.next(across), mesh_.next(mesh_.next(across))};
        } else {
            return false;
        }
        if (mesh_.info(between).kind != NodeKind::interior || mesh_.valence(between) != 2) return false;
        const std::array<Face, 2> both{mesh_.face(door), mesh_.face(across)};
        f = replace_region(mesh_, loop, both);
        return true;
    }

    /// Moves the triangle of `door` through the quad behind it, so that it lies at the half-edge `exit` of that quad.
    /// @param door in the triangle; where it is closed again, the edge may have another handle
    /// @param with_nodes puts a node into pentagons that no diagonal can cut
    /// @returns false, and nothing else changed, if that is not possible
    bool step(HalfEdge& door, HalfEdge exit, bool with_nodes) {
        const Vertex apex = mesh_.to(mesh_.next(door));
        bool holds_a_node_twice = false;
        for (const HalfEdge h : mesh_.halfedges(mesh_.face(M::twin(door)))) holds_a_node_twice |= mesh_.from(h) == apex;
        if (holds_a_node_twice && !with_nodes) return false;
        const HalfEdge back = mesh_.next(door);
        const HalfEdge back_end = mesh_.prev(door);
        // The pentagon: the triangle's apex, then the quad's nodes.
        dissolve_edge(mesh_, M::edge(door));
        const auto undo = [&] {
            insert_edge(mesh_, back, mesh_.next(back_end));
            door = mesh_.prev(back);
            return false;
        };
        if (holds_a_node_twice) {
            // As round the end of a line. The new node must not be joined to that node twice.
            const std::array<Vertex, 5> nodes = pentagon(exit);
            if (nodes[0] == nodes[3] || nodes[1] == nodes[3]) return undo();
            cut_with_node(exit);
            return true;
        }
        // The triangle takes the exit and the edge after it, or the one before it.
        const HalfEdge after = mesh_.next(exit);
        const HalfEdge before = mesh_.prev(exit);
        const double q_after = cut_quality(exit, mesh_.next(after));
        const double q_before = cut_quality(before, after);
        const bool doubled = std::max(q_after, q_before) <= kDoubled;
        if (doubled && !with_nodes) return undo();
        if (doubled) {
            cut_with_node(exit);
        } else if (q_after >= q_before) {
            insert_edge(mesh_, exit, mesh_.next(after));
        } else {
            insert_edge(mesh_, before, after);
        }
        return true;
    }

    /// Nodes of the pentagon of `exit`, from its start.
    std::array<Vertex, 5> pentagon(HalfEdge exit) const {
        std::array<Vertex, 5> nodes;
        for (Vertex& node : nodes) {
            node = mesh_.from(exit);
            exit = mesh_.next(exit);
        }
        return nodes;
    }

    /// A triangle at the exit and two quads round a new node in the middle of the pentagon: all its edges are new.
    void cut_with_node(HalfEdge exit) {
        Point centre = Point::Zero();
        for (const Vertex node : pentagon(exit)) centre += mesh_.position(node) / 5.0;
        const HalfEdge third = mesh_.next(mesh_.next(exit));
        const HalfEdge fifth = mesh_.prev(exit);
        split_face(mesh_, mesh_.face(exit), centre);
        // By their place in the pentagon, since it may hold a node twice.
        for (const HalfEdge side : {third, fifth}) dissolve_edge(mesh_, M::edge(mesh_.prev(side)));
    }

    /// Scaled Jacobian of the quad that remains when the nodes from(h) … from(g) (two edges) are cut off a pentagon.
    double cut_quality(HalfEdge h, HalfEdge g) const {
        if (mesh_.find_halfedge(mesh_.from(h), mesh_.from(g)).is_valid()) return kDoubled;
        const HalfEdge g1 = mesh_.next(g);
        const HalfEdge g2 = mesh_.next(g1);
        return scaled_jacobian(mesh_.position(mesh_.from(h)), mesh_.position(mesh_.from(g)), mesh_.position(mesh_.from(g1)),
                               mesh_.position(mesh_.from(g2)));
    }

    SurfaceMesh& mesh_;
    FinishResult result_;
    std::vector<Face> single_;
    std::vector<Face> queue_;
    std::vector<HalfEdge> path_;
    std::vector<HalfEdge> from_;
    std::vector<std::int32_t> stamp_;
    std::int32_t now_ = -1;
    std::vector<Edge> shut_;
};

}  // namespace

bool close_small_loop(SurfaceMesh& mesh, HalfEdge h, int length, bool spirals) {
    static thread_local std::vector<Face> faces;
    if (length == 4) {
        std::array<HalfEdge, 4> loop;
        for (HalfEdge& k : loop) {
            k = h;
            h = next_front(mesh, h);
        }
        const auto v = [&](std::size_t i) { return mesh.from(loop[i]); };
        if (mesh.has_face_on(v(0), v(1), v(2), v(3)) || !collect_region(mesh, loop, faces)) return false;
        const double flat = flatness(mesh, faces);
        if (flat <= kFlat) return false;
        const auto p = [&](std::size_t i) -> const Point& { return mesh.position(mesh.from(loop[i])); };
        const double q = scaled_jacobian(p(0), p(1), p(2), p(3), doubled_area_vector(mesh, faces));
        const auto is_free = [&](HalfEdge k) { return is_movable(mesh, mesh.from(k)); };
        if (q < kFolded && !(spirals && flat > kPlane && std::all_of(loop.begin(), loop.end(), is_free))) return false;
        replace_region(mesh, loop, faces);
        return true;
    }
    if (length == 6) {
        std::array<HalfEdge, 6> loop;
        for (HalfEdge& k : loop) {
            k = h;
            h = next_front(mesh, h);
        }
        return collect_region(mesh, loop, faces) && flatness(mesh, faces) > kFlat && close_six(mesh, loop, faces);
    }
    return false;
}

FinishResult finish_remaining(SurfaceMesh& mesh) { return Finish(mesh).run(); }

}  // namespace anisoquad
