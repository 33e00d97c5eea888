#include "input/check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "input/flatness.h"
#include "mesh/directed_edges.h"

namespace anisoquad {
namespace {

using Triangles = std::span<const std::array<std::int32_t, 3>>;

constexpr std::size_t kMostIds = 1000;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

std::string count(std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

/// Throws if there is any offending element. @param stride ids per element
void reject(ErrorCode code, ElementKind kind, std::vector<std::int32_t> ids, const std::string& message, std::size_t stride = 1) {
    if (ids.empty()) return;
    ids.resize(std::min(ids.size(), stride * kMostIds));
    throw Error(code, message, kind, std::move(ids));
}

class InputChecker {
  public:
    InputChecker(std::span<const Point> points, Triangles triangles, const Context& context)
        : points_(points), triangles_(triangles), context_(context) {}

    void run() {
        check_numbers();
        context_.breathe();
        check_facets();
        context_.breathe();
        edges_ = sorted_edges(points_.size(), triangles_);
        context_.breathe();
        check_duplicates();
        check_edges();
        context_.breathe();
        check_orientation();
        context_.breathe();
        check_vertices();
    }

  private:
    static std::int32_t next(std::int32_t corner) { return next_corner(corner); }
    static std::int32_t prev(std::int32_t corner) { return previous_corner(corner); }
    std::int32_t vertex(std::int32_t corner) const { return triangles_[at(corner / 3)][at(corner % 3)]; }
    std::int32_t corners() const { return 3 * static_cast<std::int32_t>(triangles_.size()); }

    void check_numbers() const {
        if (triangles_.empty()) throw Error(ErrorCode::empty_mesh, "The mesh has no triangles. Choose a mesh with at least one.");
        std::vector<std::int32_t> ids;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!points_[i].allFinite()) ids.push_back(static_cast<std::int32_t>(i));
        }
        const std::string not_finite = count(ids.size(), "vertex has", "vertices have");
        reject(ErrorCode::non_finite_coordinates, ElementKind::vertex, std::move(ids),
               not_finite + " a coordinate that is not a finite number. Import or tessellate the surface again.");
        ids.clear();
        const auto n = static_cast<std::int32_t>(points_.size());
        for (std::size_t f = 0; f < triangles_.size(); ++f) {
            const auto& t = triangles_[f];
            if (std::any_of(t.begin(), t.end(), [n](std::int32_t v) { return v < 0 || v >= n; }))
                ids.push_back(static_cast<std::int32_t>(f));
        }
        const std::string outside = count(ids.size(), "facet names", "facets name");
        reject(ErrorCode::index_out_of_range, ElementKind::facet, std::move(ids),
               outside + " a vertex that does not exist: indices go from 0 to " + std::to_string(n - 1) + ".");
    }

    void check_facets() const {
        std::vector<std::int32_t> ids;
        const double size = diagonal(points_, triangles_);
        for (std::size_t f = 0; f < triangles_.size(); ++f) {
            const auto& [a, b, c] = triangles_[f];
            if (a == b || b == c || c == a || is_degenerate(points_[at(a)], points_[at(b)], points_[at(c)], size))
                ids.push_back(static_cast<std::int32_t>(f));
        }
        const std::string flat = count(ids.size(), "facet has", "facets have");
        reject(ErrorCode::degenerate_facets, ElementKind::facet, std::move(ids),
               flat +
                   " no area: two corners are the same or at the same place, all three lie on one line, or the facet is a mere "
                   "point "
                   "beside the model. "
                   "Remove them.");
    }

    void check_duplicates() const {
        std::vector<std::int32_t> ids;
        std::vector<std::pair<std::int32_t, std::int32_t>> opposite;  // facets of one edge by their third corner
        for_each_edge(std::span<const DirectedEdge>(edges_), [&](std::span<const DirectedEdge> edge) {
            if (edge.size() < 2) return;
            opposite.clear();
            for (const DirectedEdge& e : edge) opposite.emplace_back(vertex(prev(e.corner)), e.corner / 3);
            std::sort(opposite.begin(), opposite.end());
            for (std::size_t i = 1; i < opposite.size(); ++i) {
                if (opposite[i].first == opposite[i - 1].first) ids.push_back(opposite[i].second);
            }
        });
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        const std::string copies = count(ids.size(), "facet has", "facets have");
        reject(ErrorCode::duplicate_facets, ElementKind::facet, std::move(ids),
               copies + " the same three corners as another one. Remove the copies.");
    }

    void check_edges() const {
        std::vector<std::int32_t> ids;
        for_each_edge(std::span<const DirectedEdge>(edges_), [&](std::span<const DirectedEdge> edge) {
            if (edge.size() > 2) ids.insert(ids.end(), {edge[0].low, edge[0].high});
        });
        const std::string shared = count(ids.size() / 2, "edge is", "edges are");
        reject(ErrorCode::non_manifold_edges, ElementKind::edge, std::move(ids),
               shared +
                   " shared by three or more facets. A surface has at most two at an edge: split the mesh there into separate "
                   "surfaces, or delete the surplus facets.",
               2);
    }

    /// Fills mate_; half-edges that run the same way get none.
    void check_orientation() {
        mate_.assign(edges_.size(), -1);
        std::vector<std::int32_t> neighbour(edges_.size(), -1);
        std::vector<std::int32_t> clashes;
        for_each_edge(std::span<const DirectedEdge>(edges_), [&](std::span<const DirectedEdge> edge) {
            if (edge.size() != 2) return;
            const std::int32_t a = edge[0].corner;
            const std::int32_t b = edge[1].corner;
            neighbour[at(a)] = b;
            neighbour[at(b)] = a;
            if (vertex(a) == vertex(b)) {
                clashes.insert(clashes.end(), {edge[0].low, edge[0].high});
            } else {
                mate_[at(a)] = b;
                mate_[at(b)] = a;
            }
        });
        if (clashes.empty()) return;
        std::vector<std::int32_t> turned;
        if (!find_turned(neighbour, turned)) {
            reject(ErrorCode::inconsistent_orientation, ElementKind::edge, std::move(clashes),
                   "The surface has only one side (like a Moebius strip), so its facets cannot be oriented. Cut it open along a "
                   "line.",
                   2);
        }
        const std::string wrong = count(turned.size(), "facet is", "facets are");
        reject(ErrorCode::inconsistent_orientation, ElementKind::facet, std::move(turned),
               wrong + " turned the other way than the rest of the surface. Flip them (harmonize the normals).");
    }

    /// The smaller set of facets of every component that must be flipped. @returns false if the surface is one-sided
    bool find_turned(const std::vector<std::int32_t>& neighbour, std::vector<std::int32_t>& turned) const {
        std::vector<std::int8_t> side(triangles_.size(), -1);
        std::vector<std::int32_t> component;
        for (std::int32_t seed = 0; seed < corners() / 3; ++seed) {
            if (side[at(seed)] >= 0) continue;
            side[at(seed)] = 0;
            component.assign(1, seed);
            std::size_t flipped = 0;
            for (std::size_t i = 0; i < component.size(); ++i) {
                for (std::int32_t c = 3 * component[i]; c < 3 * component[i] + 3; ++c) {
                    const std::int32_t other = neighbour[at(c)];
                    if (other < 0) continue;
                    const bool clash = vertex(c) == vertex(other);
                    const auto wanted = static_cast<std::int8_t>(side[at(component[i])] ^ static_cast<int>(clash));
                    if (side[at(other / 3)] < 0) {
                        side[at(other / 3)] = wanted;
                        flipped += static_cast<std::size_t>(wanted);
                        component.push_back(other / 3);
                    } else if (side[at(other / 3)] != wanted) {
                        return false;
                    }
                }
            }
            const std::int8_t minority = 2 * flipped <= component.size() ? 1 : 0;
            for (const std::int32_t f : component) {
                if (side[at(f)] == minority) turned.push_back(f);
            }
        }
        std::sort(turned.begin(), turned.end());
        return true;
    }

    void check_vertices() const {
        std::vector<char> seen(edges_.size(), 0);
        std::vector<char> fans(points_.size(), 0);
        std::vector<std::int32_t> ids;
        for (std::int32_t c = 0; c < corners(); ++c) {
            if (seen[at(c)]) continue;
            char& n = fans[at(vertex(c))];
            if (n == 1) ids.push_back(vertex(c));
            n = static_cast<char>(std::min(n + 1, 2));
            for (std::int32_t k = c; k >= 0 && !seen[at(k)]; k = mate_[at(prev(k))]) seen[at(k)] = 1;
            for (std::int32_t k = mate_[at(c)]; k >= 0 && !seen[at(next(k))]; k = mate_[at(next(k))]) seen[at(next(k))] = 1;
        }
        std::sort(ids.begin(), ids.end());
        const std::string pinched = count(ids.size(), "vertex joins", "vertices join");
        reject(ErrorCode::non_manifold_vertices, ElementKind::vertex, std::move(ids),
               pinched + " parts of the surface that share no edge there. Give each part its own vertex at that place.");
    }

    std::span<const Point> points_;
    Triangles triangles_;
    const Context& context_;
    std::vector<DirectedEdge> edges_;
    std::vector<std::int32_t> mate_;  ///< per corner: half-edge on the other side, -1 = boundary
};

/// The mesh's vertex that is the input vertex v.
Vertex mesh_vertex(std::int32_t v, std::span<const std::int32_t> rank) { return Vertex(rank.empty() ? v : rank[at(v)]); }

class SourceChecker {
  public:
    SourceChecker(const SurfaceMesh& mesh, std::span<const std::int32_t> rank)
        : mesh_(mesh), rank_(rank), use_(at(mesh.vertex_slots()), Use::none), edge_used_(at(mesh.edge_slots()), 0) {}

    void check(const Source& source, std::size_t index) {
        name_ = "Source " + std::to_string(index) + ": ";
        check_passes(source);
        check_path(source.vertices);
        check_contacts(source.vertices);
    }

  private:
    enum class Use : std::uint8_t { none, end, inner };

    [[noreturn]] void fail(const std::string& message, ElementKind kind = ElementKind::none,
                           std::vector<std::int32_t> ids = {}) const {
        throw Error(ErrorCode::invalid_source, name_ + message, kind, std::move(ids));
    }

    void check_passes(const Source& source) const {
        for (const Pass& pass : source.passes) {
            if (pass.ratio < 1) throw Error(ErrorCode::invalid_option, name_ + "a pass's ratio must be 1 or more.");
            if (pass.rows < 0)
                throw Error(ErrorCode::invalid_option, name_ + "a pass's number of rows must be 0 (automatic) or more.");
        }
    }

    void check_path(const std::vector<std::int32_t>& nodes) {
        if (nodes.size() < 2) fail("a line needs at least two vertices.", ElementKind::vertex, nodes);
        for (const std::int32_t v : nodes) {
            if (v < 0 || v >= mesh_.vertex_slots())
                fail("vertex " + std::to_string(v) + " does not exist.", ElementKind::vertex, {v});
        }
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            const HalfEdge h = mesh_.find_halfedge(mesh_vertex(nodes[i], rank_), mesh_vertex(nodes[i + 1], rank_));
            const std::string pair = std::to_string(nodes[i]) + " and " + std::to_string(nodes[i + 1]);
            if (!h.is_valid()) {
                fail("vertices " + pair +
                         " are not joined by an edge of the mesh. A line runs along edges: list every vertex on its way.",
                     ElementKind::edge, {nodes[i], nodes[i + 1]});
            }
            char& used = edge_used_[at(SurfaceMesh::edge(h).index())];
            if (used) fail("the edge between vertices " + pair + " is used twice.", ElementKind::edge, {nodes[i], nodes[i + 1]});
            used = 1;
        }
    }

    void check_contacts(const std::vector<std::int32_t>& nodes) {
        const bool closed = nodes.front() == nodes.back();
        for (std::size_t i = 0; i < nodes.size() - (closed ? 1 : 0); ++i) {
            const bool is_end = !closed && (i == 0 || i + 1 == nodes.size());
            Use& use = use_[at(nodes[i])];
            if (use == Use::inner || (use == Use::end && !is_end)) {
                fail("the line touches itself or another line at vertex " + std::to_string(nodes[i]) +
                         ". Lines may only meet where both end: cut the one that goes on there in two.",
                     ElementKind::vertex, {nodes[i]});
            }
            use = is_end ? Use::end : Use::inner;
        }
    }

    const SurfaceMesh& mesh_;
    std::span<const std::int32_t> rank_;
    std::vector<Use> use_;  ///< by the sources so far
    std::vector<char> edge_used_;
    std::string name_;
};

[[noreturn]] void invalid_option(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

}  // namespace

void check_input(std::span<const Point> points, Triangles triangles, const Context& context) {
    InputChecker(points, triangles, context).run();
}

void check_sources(const SurfaceMesh& mesh, std::span<const Source> sources, std::span<const std::int32_t> rank) {
    SourceChecker checker(mesh, rank);
    for (std::size_t i = 0; i < sources.size(); ++i) checker.check(sources[i], i);
}

void check_options(const Options& options, std::size_t points) {
    if (!(options.feature_angle > 0.0 && options.feature_angle <= 180.0)) {
        invalid_option("The feature angle must be above 0 and at most 180 degrees.");
    }
    if (!(options.row_growth >= 1.0 && std::isfinite(options.row_growth))) invalid_option("The row growth must be 1 or more.");
    if (!(options.size >= 0.0 && std::isfinite(options.size)))
        invalid_option("The size must be 0 (that of the triangles) or a length.");
    const auto is_length = [](double size) { return size > 0.0 && std::isfinite(size); };
    if (!options.vertex_size.empty() && options.vertex_size.size() != points) {
        invalid_option("There must be one size per vertex: " + std::to_string(options.vertex_size.size()) +
                       " sizes were given for " + std::to_string(points) + " vertices.");
    }
    if (!std::all_of(options.vertex_size.begin(), options.vertex_size.end(), is_length)) {
        invalid_option("The sizes per vertex must be lengths above 0.");
    }
    if (!(options.growth > 1.0 && std::isfinite(options.growth))) invalid_option("The growth must be above 1.");
    if (!(options.curvature_angle >= 0.0 && options.curvature_angle <= 180.0)) {
        invalid_option("The curvature angle must be between 0 and 180 degrees.");
    }
    if (options.threads < 0) invalid_option("The number of threads must be 0 (all cores) or more.");
    if (options.smoothing_passes < 0) invalid_option("The number of smoothing passes must be 0 or more.");
}

void check_feature_edges(const SurfaceMesh& mesh, std::span<const std::array<std::int32_t, 2>> edges,
                         std::span<const std::int32_t> rank) {
    std::vector<std::int32_t> ids;
    for (const auto& [a, b] : edges) {
        const auto exists = [&](std::int32_t v) { return v >= 0 && v < mesh.vertex_slots(); };
        if (!exists(a) || !exists(b) || !mesh.find_halfedge(mesh_vertex(a, rank), mesh_vertex(b, rank)).is_valid())
            ids.insert(ids.end(), {a, b});
    }
    const std::string wrong = count(ids.size() / 2, "feature edge is", "feature edges are");
    reject(ErrorCode::invalid_feature_edge, ElementKind::edge, std::move(ids),
           wrong + " not an edge of the mesh. A feature edge is a pair of vertices that an edge joins.", 2);
}

}  // namespace anisoquad
