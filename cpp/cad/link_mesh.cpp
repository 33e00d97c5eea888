#include "cad/link_mesh.h"

#include <algorithm>
#include <cmath>

#include "cad/check_triangles.h"
#include "cad/facet_parameters.h"
#include "cad/facet_regions.h"
#include "cad/to_eigen.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

using Eigen::Vector3d;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// @throws Error{shape_mismatch} with the edges between faces that the mesh does not follow
void check_paths(const CadShape& shape, std::span<const EdgePath> paths) {
    std::vector<std::int32_t> missing;
    for (std::size_t e = 0; e < paths.size(); ++e) {
        if (shape.edges()[e].is_border() && !shape.edges()[e].faces.empty() && paths[e].vertices.empty())
            missing.push_back(static_cast<std::int32_t>(e));
    }
    if (missing.empty()) return;
    throw Error(
        ErrorCode::shape_mismatch,
        "The mesh does not follow " + CadShape::names("Edge", missing) + " of " + shape.name() + ": they do not belong together.",
        ElementKind::cad_edge, missing);
}

/// @throws Error{shape_mismatch} with the edges of the mesh's boundary that lie on no CAD edge
void check_boundary(const CadShape& shape, Triangles triangles, std::span<const std::array<std::int32_t, 3>> neighbours,
                    const PathEdges& on_path) {
    std::vector<std::int32_t> open;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = triangles[f][k];
            const std::int32_t b = triangles[f][(k + 1) % 3];
            if (neighbours[f][k] < 0 && on_path.find(a, b).edge < 0) open.insert(open.end(), {a, b});
        }
    }
    if (open.empty()) return;
    throw Error(ErrorCode::shape_mismatch, "The mesh ends where " + shape.name() + " has no edge: they do not belong together.",
                ElementKind::edge, open);
}

/// @throws Error{shape_mismatch} with the vertices that are too far off
void check_distances(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles,
                     std::span<const double> distance, double tolerance) {
    std::vector<double> length(points.size(), 0.0);
    std::vector<int> edges(points.size(), 0);
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double l = (points[at(t[k])] - points[at(t[(k + 1) % 3])]).norm();
            for (const std::int32_t v : {t[k], t[(k + 1) % 3]}) {
                length[at(v)] += l;
                ++edges[at(v)];
            }
        }
    }
    std::vector<std::int32_t> off;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (edges[v] > 0 && distance[v] > std::max(kRounding * shape.diagonal(), tolerance * length[v] / edges[v]))
            off.push_back(static_cast<std::int32_t>(v));
    }
    if (off.empty()) return;
    throw Error(
        ErrorCode::shape_mismatch,
        std::to_string(off.size()) + " vertices of the mesh are not on " + shape.name() + ": they do not belong together.",
        ElementKind::vertex, off);
}

}  // namespace

MeshLink link_mesh(const CadShape& shape, std::span<const Vector3d> points, Triangles triangles, const TriangleOrigin& known,
                   const LinkOptions& options) {
    check_triangles(points, triangles);
    EdgePaths traced = find_edge_paths(shape, points, triangles, options.on_edge, known.paths);
    check_paths(shape, traced.paths);
    const PathEdges on_path(traced.paths);
    const auto neighbours = facet_neighbours(triangles);
    check_boundary(shape, triangles, neighbours, on_path);

    MeshLink link;
    link.facet_face = find_facet_faces(shape, points, triangles, neighbours, on_path, traced.paths, known.facet_face);
    FacetParameters parameters = find_facet_parameters(shape, points, triangles, neighbours, on_path, link.facet_face);
    check_distances(shape, points, triangles, parameters.distance, options.on_face);
    link.facet_parameter = std::move(parameters.corner);
    link.points = std::move(parameters.on_face);

    link.entity.resize(points.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (const std::int32_t v : triangles[f]) link.entity[at(v)] = {EntityKind::face, link.facet_face[f]};
    }
    for (std::size_t e = 0; e < traced.paths.size(); ++e) {
        const EdgePath& path = traced.paths[e];
        for (std::size_t i = 0; i < path.vertices.size() && path.vertices.size() > 1; ++i) {
            link.entity[at(path.vertices[i])] = {EntityKind::edge, static_cast<std::int32_t>(e)};
            link.points[at(path.vertices[i])] = to_eigen(shape.edges()[e].curve->Value(path.parameters[i]));
        }
    }
    for (std::size_t i = 0; i < traced.at_vertex.size(); ++i) {
        const std::int32_t v = traced.at_vertex[i];
        if (v < 0) continue;
        link.entity[at(v)] = {EntityKind::vertex, static_cast<std::int32_t>(i)};
        link.points[at(v)] = shape.vertices()[i];
    }
    link.paths = std::move(traced.paths);
    return link;
}

}  // namespace anisoquad::cad
