#include "anisotropy/refine_row.h"

#include <array>

#include "anisotropy/rows.h"
#include "mesh/euler_operators.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
constexpr double kTooLong = 1.5;         // front edge over local size from which a column is refined
constexpr double kHeightOfWidth = 0.45;  // wanted height of a refining row over the length of the front's edges
constexpr double kLeastHeight = 0.35;    // below it the template's quads become too flat
constexpr double kGrowth = 2.2;          // of a refining row: half of its height counts for the quads next to the row below
constexpr double kPlainGrowth = 1.6;     // of rows that only gain height
constexpr int kMostRows = 10;

class RefineRow {
  public:
    RefineRow(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference)
        : mesh_(mesh), stack_(stack), size_(size), reference_(reference) {}

    bool run() {
        const std::vector<char> pair_starts = choose_pairs();
        bool any = false;
        for (const char c : pair_starts) any = any || c;
        if (!any) return false;
        RowLimits limits;
        const bool plain = kGrowth * mean_height() < kLeastHeight * mean_width(pair_starts);
        limits.height_of_width = kHeightOfWidth;
        limits.growth = plain ? kPlainGrowth : kGrowth;
        limits.is_row = false;
        limits.merged = 1;
        limits.longest_height = 1e9;
        if (!build_row(mesh_, stack_, size_, reference_, limits)) return false;
        if (plain) return true;
        const std::vector<Vertex> bottom = stack_.layers[stack_.layers.size() - 2];
        const std::vector<Vertex> top = stack_.top();
        std::vector<Vertex> refined;
        for (std::size_t i = 0; i + 1 < bottom.size(); ++i) {
            refined.push_back(top[i]);
            if (!pair_starts[i]) continue;
            const Vertex t1 = halve_top(top[i], top[i + 1]);
            const Vertex t3 = halve_top(top[i + 1], top[i + 2]);
            const Vertex c = halve(bottom[i + 1], top[i + 1]);
            star(bottom[i], bottom[i + 1], {bottom[i], t1, c});
            star(bottom[i + 1], bottom[i + 2], {bottom[i + 2], t3, c});
            refined.insert(refined.end(), {t1, top[i + 1], t3});
            ++i;
        }
        refined.push_back(top.back());
        stack_.layers.back() = refined;
        // Below the new top only its own height is asked for: one node for each.
        stack_.layers[stack_.layers.size() - 2] = nearest_below(refined, bottom, top);
        return true;
    }

  private:
    /// First columns of the pairs that are refined: both too long for the local size.
    std::vector<char> choose_pairs() const {
        const std::vector<Vertex>& nodes = stack_.top();
        std::vector<char> starts(nodes.size(), 0);
        std::int32_t hint = -1;
        const auto too_long = [&](std::size_t i) {
            const Point& a = mesh_.position(nodes[i]);
            const Point& b = mesh_.position(nodes[i + 1]);
            return (b - a).norm() > kTooLong * size_(0.5 * (a + b), hint);
        };
        for (std::size_t i = 0; i + 2 < nodes.size(); ++i) {
            if (!too_long(i) || !too_long(i + 1)) continue;
            starts[i] = 1;
            ++i;
        }
        return starts;
    }

    double mean_height() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < stack_.top().size(); ++i) sum += stack_.height(mesh_, i);
        return sum / static_cast<double>(stack_.top().size());
    }

    double mean_width(const std::vector<char>& pair_starts) const {
        const std::vector<Vertex>& nodes = stack_.top();
        double sum = 0.0;
        int pairs = 0;
        for (std::size_t i = 0; i + 2 < nodes.size(); ++i) {
            if (!pair_starts[i]) continue;
            sum += (mesh_.position(nodes[i + 2]) - mesh_.position(nodes[i])).norm();
            ++pairs;
        }
        return sum / (2.0 * pairs);
    }

    Vertex halve(Vertex a, Vertex b) {
        const HalfEdge h = mesh_.find_halfedge(a, b);
        const Vertex v = insert_vertex(mesh_, M::edge(h), 0.5 * (mesh_.position(a) + mesh_.position(b)));
        settle(v, mesh_.info(mesh_.face(h)).patch);
        return v;
    }

    /// Halves an edge on top of the row; the triangle ahead is cut in two.
    Vertex halve_top(Vertex a, Vertex b) {
        const Vertex v = halve(a, b);
        for (const HalfEdge out : mesh_.outgoing(v)) {
            const Face f = mesh_.face(out);
            if (f.is_valid() && mesh_.valence(f) == 4) {
                insert_edge(mesh_, out, mesh_.next(mesh_.next(out)));
                break;
            }
        }
        mesh_.info(v).in_row = true;
        return v;
    }

    /// Joins a new node inside the six-sided face of a – b with three of its nodes.
    void star(Vertex a, Vertex b, const std::array<Vertex, 3>& ends) {
        const Face f = mesh_.face(mesh_.find_halfedge(a, b));
        Point centre = Point::Zero();
        for (const Vertex v : ends) centre += mesh_.position(v) / 3.0;
        const std::int32_t patch = mesh_.info(f).patch;
        const Vertex m = split_face(mesh_, f, centre);
        std::array<Edge, 6> spokes;
        std::size_t n = 0;
        for (const HalfEdge out : mesh_.outgoing(m)) spokes[n++] = M::edge(out);
        for (const Edge e : spokes) {
            const HalfEdge h = M::halfedge(e);
            const Vertex end = mesh_.from(h) == m ? mesh_.to(h) : mesh_.from(h);
            if (end != ends[0] && end != ends[1] && end != ends[2]) dissolve_edge(mesh_, e);
        }
        settle(m, patch);
    }

    void settle(Vertex v, std::int32_t patch) {
        std::int32_t hint = -1;
        mesh_.position(v) = reference_.project(mesh_.position(v), patch, hint);
    }

    /// For each node of the refined top the node below from which its height is taken.
    static std::vector<Vertex> nearest_below(const std::vector<Vertex>& refined, const std::vector<Vertex>& bottom, const std::vector<Vertex>& top) {
        std::vector<Vertex> below;
        std::size_t i = 0;
        for (const Vertex v : refined) {
            if (i + 1 < top.size() && v == top[i + 1]) ++i;
            below.push_back(bottom[i]);
        }
        return below;
    }

    SurfaceMesh& mesh_;
    RowStack& stack_;
    const LocalSize& size_;
    const ReferenceSurface& reference_;
};

}  // namespace

int refine_to_local_size(SurfaceMesh& mesh, RowStack& stack, const LocalSize& size, const ReferenceSurface& reference) {
    int rows = 0;
    while (rows < kMostRows && RefineRow(mesh, stack, size, reference).run()) ++rows;
    return rows;
}

}  // namespace anisoquad
