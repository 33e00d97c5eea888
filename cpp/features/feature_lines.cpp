#include "features/feature_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "input/check.h"
#include "mesh/area_vector.h"
#include "parallel.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// Cosine of the turn above which a node of a line is a corner.
constexpr double kCornerCosine = std::numbers::sqrt2 / 2.0;

class FeatureFinder {
  public:
    FeatureFinder(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options,
                  std::span<const std::array<std::int32_t, 2>> ridges)
        : mesh_(mesh),
          sources_(sources),
          options_(options),
          ridges_(ridges),
          edges_(static_cast<std::size_t>(mesh.edge_slots())) {}

    std::vector<FeatureLine> run() {
        reset();
        mark_edges();
        mark_corners();
        for (std::size_t i = 0; i < sources_.size(); ++i) add_source(static_cast<std::int32_t>(i));
        add_other_lines();
        return std::move(lines_);
    }

  private:
    /// What an edge is; the edges of one line are all the same.
    struct EdgeKind {
        bool constrained = false;
        bool boundary = false;
        bool ridge = false;
        std::int32_t source = -1;
        bool operator==(const EdgeKind&) const = default;
    };

    EdgeKind& kind(Edge e) { return edges_[static_cast<std::size_t>(e.index())]; }
    EdgeKind& kind(HalfEdge h) { return kind(M::edge(h)); }
    bool is_corner(Vertex v) const { return mesh_.info(v).kind == NodeKind::corner; }

    void reset() {
        for (std::int32_t i = 0; i < mesh_.edge_slots(); ++i) mesh_.info(Edge(i)) = {};
        for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
            mesh_.info(Vertex(i)).line = -1;
            mesh_.info(Vertex(i)).kind = NodeKind::interior;
        }
    }

    void mark_edges() {
        std::vector<Eigen::Vector3d> normals(static_cast<std::size_t>(mesh_.face_slots()));
        for_each(mesh_.face_slots(), [&](std::int32_t i) {
            if (!mesh_.is_deleted(Face(i)))
                normals[static_cast<std::size_t>(i)] = doubled_area_vector(mesh_, Face(i)).normalized();
        });
        const double flattest = std::cos(options_.feature_angle * std::numbers::pi / 180.0);
        for_each(mesh_.edge_slots(), [&](std::int32_t i) {
            const Edge e(i);
            if (mesh_.is_deleted(e)) return;
            if (mesh_.is_boundary(e)) {
                kind(e) = {true, true, false, -1};
                return;
            }
            const auto& n = normals[static_cast<std::size_t>(mesh_.face(M::halfedge(e, 0)).index())];
            const auto& m = normals[static_cast<std::size_t>(mesh_.face(M::halfedge(e, 1)).index())];
            kind(e).constrained = std::max(-1.0, n.dot(m)) < flattest;  // rounding makes no turn of more than 180 degrees
        });
        for (const auto& [a, b] : ridges_) {
            EdgeKind& k = kind(mesh_.find_halfedge(Vertex(a), Vertex(b)));
            k.ridge = !k.constrained;
            k.constrained = true;
        }
        for (const auto& [a, b] : options_.feature_edges) kind(mesh_.find_halfedge(Vertex(a), Vertex(b))).constrained = true;
        for (std::size_t s = 0; s < sources_.size(); ++s) {
            const auto& nodes = sources_[s].vertices;
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                EdgeKind& k = kind(mesh_.find_halfedge(Vertex(nodes[i]), Vertex(nodes[i + 1])));
                k.constrained = true;
                k.ridge = false;
                k.source = static_cast<std::int32_t>(s);
            }
        }
    }

    void mark_corners() {
        for_each(mesh_.vertex_slots(), [&](std::int32_t i) {
            const Vertex v(i);
            if (mesh_.is_deleted(v)) return;
            std::array<HalfEdge, 2> out;
            std::size_t n = 0;
            for (const HalfEdge h : mesh_.outgoing(v)) {
                if (!kind(h).constrained) continue;
                if (n < 2) out[n] = h;
                ++n;
            }
            if (n == 0) return;
            const bool smooth =
                n == 2 && kind(out[0]) == kind(out[1]) && -direction(out[0]).dot(direction(out[1])) >= kCornerCosine;
            mesh_.info(v).kind = smooth ? NodeKind::line : NodeKind::corner;
        });
        for (const Source& source : sources_) {
            if (source.vertices.front() == source.vertices.back()) continue;
            mesh_.info(Vertex(source.vertices.front())).kind = NodeKind::corner;
            mesh_.info(Vertex(source.vertices.back())).kind = NodeKind::corner;
        }
    }

    Eigen::Vector3d direction(HalfEdge h) const {
        return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).normalized();
    }

    /// The source's lines run in its direction, cut at its corners; a closed source without one starts where the user began.
    void add_source(std::int32_t index) {
        std::vector<Vertex> nodes;
        for (const std::int32_t v : sources_[static_cast<std::size_t>(index)].vertices) nodes.emplace_back(v);
        if (nodes.front() == nodes.back()) {
            nodes.pop_back();
            std::size_t first = 0;
            while (first < nodes.size() && !is_corner(nodes[first])) ++first;
            if (first < nodes.size()) std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end());
            nodes.push_back(nodes.front());
        }
        std::vector<Vertex> part(1, nodes.front());
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            part.push_back(nodes[i]);
            if (!is_corner(nodes[i]) && i + 1 < nodes.size()) continue;
            add_line(std::exchange(part, {nodes[i]}));
        }
    }

    /// Lines from corner to corner, then the closed ones that have no corner.
    void add_other_lines() {
        for (const bool from_corners : {true, false}) {
            for (std::int32_t i = 0; i < mesh_.vertex_slots(); ++i) {
                if (mesh_.is_deleted(Vertex(i)) || is_corner(Vertex(i)) != from_corners) continue;
                for (const HalfEdge h : mesh_.outgoing(Vertex(i))) {
                    if (kind(h).constrained && mesh_.info(M::edge(h)).line < 0) add_line(walk(h));
                }
            }
        }
    }

    std::vector<Vertex> walk(HalfEdge h) {
        std::vector<Vertex> nodes{mesh_.from(h), mesh_.to(h)};
        while (!is_corner(nodes.back()) && nodes.back() != nodes.front()) {
            for (const HalfEdge out : mesh_.outgoing(nodes.back())) {
                if (out == M::twin(h) || !kind(out).constrained) continue;
                h = out;
                break;
            }
            nodes.push_back(mesh_.to(h));
        }
        return nodes;
    }

    void add_line(std::vector<Vertex> nodes) {
        const auto index = static_cast<std::int32_t>(lines_.size());
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            EdgeInfo& info = mesh_.info(M::edge(mesh_.find_halfedge(nodes[i], nodes[i + 1])));
            info.line = index;
            info.source = kind(mesh_.find_halfedge(nodes[i], nodes[i + 1])).source >= 0;
        }
        for (const Vertex v : nodes) {
            if (mesh_.info(v).line < 0) mesh_.info(v).line = index;
        }
        const EdgeKind k = kind(mesh_.find_halfedge(nodes[0], nodes[1]));
        const bool closed = nodes.front() == nodes.back();
        lines_.push_back({std::move(nodes), closed, k.source >= 0, k.ridge, k.boundary, k.source});
    }

    SurfaceMesh& mesh_;
    std::span<const Source> sources_;
    const Options& options_;
    std::span<const std::array<std::int32_t, 2>> ridges_;
    std::vector<EdgeKind> edges_;
    std::vector<FeatureLine> lines_;
};

}  // namespace

std::vector<FeatureLine> find_features(SurfaceMesh& mesh, std::span<const Source> sources, const Options& options,
                                       std::span<const std::array<std::int32_t, 2>> ridges) {
    check_feature_edges(mesh, options.feature_edges);
    return FeatureFinder(mesh, sources, options, ridges).run();
}

}  // namespace anisoquad
