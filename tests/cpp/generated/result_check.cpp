#include "generated/result_check.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "features/feature_lines.h"
#include "input/working_input.h"
#include "mesh/validate.h"

namespace anisoquad::generated {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

class Checker {
  public:
    Checker(const MeshCase& surface, const QuadMeshResult& result) : case_(surface), result_(result) {}

    std::vector<std::string> run() {
        check_arrays();
        if (!defects_.empty()) return defects_;
        collect_edges();
        check_topology();
        check_lines();
        return defects_;
    }

  private:
    void expect(bool holds, const std::string& what) {
        if (!holds) defects_.push_back(what);
    }

    void check_arrays() {
        const auto n = static_cast<std::int32_t>(result_.points.size());
        std::vector<char> used(result_.points.size(), 0);
        for (const auto& q : result_.quads) {
            std::set<std::int32_t> nodes(q.begin(), q.end());
            expect(*nodes.begin() >= 0 && *nodes.rbegin() < n,
                   "a quad with a node that does not exist (a triangle that is left)");
            expect(nodes.size() == 4, "a quad with a node twice");
            if (!defects_.empty()) return;
            for (const std::int32_t v : q) used[static_cast<std::size_t>(v)] = 1;
        }
        expect(!result_.quads.empty(), "no quads");
        expect(std::count(used.begin(), used.end(), 0) == 0, "a point without a quad");
        for (const Point& p : result_.points) {
            expect(p.allFinite(), "a point that is not finite");
            if (!defects_.empty()) return;
        }
        expect(result_.report.triangles_left == 0, "the report counts triangles that are left");
        expect(result_.row.size() == result_.quads.size() && result_.patch.size() == result_.quads.size(),
               "wrong length of an array");
        expect(result_.node_line.size() == result_.points.size() && result_.node_input.size() == result_.points.size(),
               "wrong length of an array");
    }

    void collect_edges() {
        std::vector<Pair> directed;
        for (const auto& q : result_.quads) {
            for (std::size_t k = 0; k < 4; ++k) directed.emplace_back(q[k], q[(k + 1) % 4]);
        }
        std::sort(directed.begin(), directed.end());
        expect(std::adjacent_find(directed.begin(), directed.end()) == directed.end(), "an edge with two quads on one side");
        for (const auto& [a, b] : directed) {
            edges_.insert(std::minmax(a, b));
            if (!std::binary_search(directed.begin(), directed.end(), Pair(b, a))) boundary_.emplace_back(a, b);
        }
    }

    std::int32_t count_sets(const std::vector<Pair>& links, const std::vector<std::int32_t>& of) const {
        std::vector<std::int32_t> parent(result_.points.size());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](std::int32_t v) {
            while (parent[static_cast<std::size_t>(v)] != v) v = parent[static_cast<std::size_t>(v)];
            return v;
        };
        for (const auto& [a, b] : links) {
            const auto [low, high] = std::minmax({root(a), root(b)});
            parent[static_cast<std::size_t>(high)] = low;
        }
        std::set<std::int32_t> roots;
        for (const std::int32_t v : of) roots.insert(root(v));
        return static_cast<std::int32_t>(roots.size());
    }

    void check_topology() {
        const Topology before = topology(case_.shape.mesh());
        std::vector<std::int32_t> all(result_.points.size());
        std::iota(all.begin(), all.end(), 0);
        std::vector<std::int32_t> rim;
        for (const auto& [a, b] : boundary_) rim.push_back(a);
        std::vector<std::int32_t> distinct = rim;
        std::sort(distinct.begin(), distinct.end());
        expect(std::adjacent_find(distinct.begin(), distinct.end()) == distinct.end(), "the boundary touches itself");
        const std::vector<Pair> edges(edges_.begin(), edges_.end());
        expect(count_sets(edges, all) == before.components, "the number of components changed");
        expect(count_sets(boundary_, rim) == before.boundary_loops, "the number of boundary loops changed");
        const auto euler = static_cast<std::int32_t>(result_.points.size()) - static_cast<std::int32_t>(edges_.size()) +
                           static_cast<std::int32_t>(result_.quads.size());
        expect(euler == before.euler_characteristic, "the Euler characteristic changed");
    }

    /// Boundary and feature lines are edges of quads, all of them, and as long as those of the input.
    void check_lines() {
        std::set<Pair> lines;
        double length = 0.0;
        for (const auto& [a, b, line] : result_.line_edges) {
            lines.insert(std::minmax(a, b));
            length += (result_.points[static_cast<std::size_t>(a)] - result_.points[static_cast<std::size_t>(b)]).norm();
        }
        expect(std::includes(edges_.begin(), edges_.end(), lines.begin(), lines.end()), "a line edge that no quad has");
        for (const auto& [a, b] : boundary_) {
            expect(lines.count(std::minmax(a, b)) == 1, "a boundary edge on no line");
            if (!defects_.empty()) return;
        }
        // Nodes slide along their lines only; a curved line may become a little shorter where it is remeshed. Facets that
        // turn by the very feature angle may be a feature or not, and remeshing makes lines of folds too.
        const Options& options = case_.options;
        const bool may_remesh = options.prepare || options.size > 0.0 || !options.vertex_size.empty();
        const double most = may_remesh ? std::numeric_limits<double>::infinity() : 1.001 * length_of_lines(-1e-4);
        const double least = (may_remesh ? 0.7 : 0.9) * length_of_lines(1e-4);
        expect(length <= most && length >= least, "lines of length " + std::to_string(length) + ", expected " +
                                                      std::to_string(least) + " to " + std::to_string(most));
    }

    double length_of_lines(double change_of_angle) const {
        WorkingInput input(case_.shape.points, case_.shape.triangles, false, no_context());
        SurfaceMesh mesh = from_arrays(input.points(), input.triangles());
        std::vector<Source> sources = case_.sources;
        Options options = case_.options;
        options.vertex_size.clear();  // of no matter here, and of the input before a repair
        input.put_in_order(sources, options);
        input.collapse_needles_of(mesh, sources, options, no_context());
        input.turn_slivers_of(mesh, sources, options);
        options.feature_angle = std::min(180.0, options.feature_angle + change_of_angle);
        find_features(mesh, sources, options);
        double sum = 0.0;
        for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
            if (mesh.info(Edge(e)).line >= 0) sum += mesh.length(Edge(e));
        }
        return sum * input.scale();
    }

    const MeshCase& case_;
    const QuadMeshResult& result_;
    std::set<Pair> edges_;
    std::vector<Pair> boundary_;
    std::vector<std::string> defects_;
};

}  // namespace

std::vector<std::string> defects(const MeshCase& surface, const QuadMeshResult& result) { return Checker(surface, result).run(); }

}  // namespace anisoquad::generated
