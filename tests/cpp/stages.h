#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/validate.h"
#include "quality/metrics.h"
#include "shapes.h"
#include "surface/reference_surface.h"

/// The mesh on its way, and what must hold at every stage.
namespace anisoquad::stages {

/// A shape with features and patches found, as the stages after them get it.
struct Prepared {
    shapes::Shape shape;
    SurfaceMesh mesh;
    Topology before;
    ReferenceSurface reference;

    explicit Prepared(const shapes::Shape& of, const std::vector<Source>& sources = {}, const Options& options = {})
        : shape(of), mesh(of.mesh()), before(topology(mesh)) {
        find_features(mesh, sources, options);
        find_patches(mesh);
        std::vector<std::int32_t> patch;
        for (std::int32_t f = 0; f < mesh.face_slots(); ++f) patch.push_back(mesh.info(Face(f)).patch);
        reference = ReferenceSurface(shape.points, shape.triangles, patch);
    }
};

inline Source source(std::vector<std::int32_t> vertices, std::vector<Pass> passes = {{2, 0}}, Sides sides = Sides::both) {
    return {std::move(vertices), std::move(passes), sides};
}

/// first, first + step … last.
inline std::vector<std::int32_t> path(std::int32_t first, std::int32_t last, std::int32_t step) {
    std::vector<std::int32_t> vertices;
    for (std::int32_t v = first; v != last; v += step) vertices.push_back(v);
    vertices.push_back(last);
    return vertices;
}

/// Ring j of a band with n points a ring, closed.
inline std::vector<std::int32_t> ring(int n, int j) {
    std::vector<std::int32_t> vertices = path(j * n, j * n + n - 1, 1);
    vertices.push_back(j * n);
    return vertices;
}

inline std::vector<Face> faces(const SurfaceMesh& mesh) {
    std::vector<Face> all;
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) {
        if (!mesh.is_deleted(Face(f))) all.emplace_back(f);
    }
    return all;
}

inline std::vector<Edge> edges(const SurfaceMesh& mesh) {
    std::vector<Edge> all;
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (!mesh.is_deleted(Edge(e))) all.emplace_back(e);
    }
    return all;
}

inline std::vector<Vertex> vertices(const SurfaceMesh& mesh) {
    std::vector<Vertex> all;
    for (std::int32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (!mesh.is_deleted(Vertex(v)) && mesh.halfedge(Vertex(v)).is_valid()) all.emplace_back(v);
    }
    return all;
}

inline int triangle_count(const SurfaceMesh& mesh) {
    int n = 0;
    for (const Face f : faces(mesh)) n += mesh.is_triangle(f);
    return n;
}

inline int quad_count(const SurfaceMesh& mesh) { return static_cast<int>(faces(mesh).size()) - triangle_count(mesh); }

/// Sum of the cross products of the triangles that a fan from the first node makes of the face: twice its area vector.
inline Eigen::Vector3d doubled_area(const SurfaceMesh& mesh, Face f) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Point& p = mesh.position(mesh.from(mesh.halfedge(f)));
    for (const HalfEdge h : mesh.halfedges(f)) sum += (mesh.position(mesh.from(h)) - p).cross(mesh.position(mesh.to(h)) - p);
    return sum;
}

inline Point centre(const SurfaceMesh& mesh, Face f) {
    Point sum = Point::Zero();
    for (const HalfEdge h : mesh.halfedges(f)) sum += mesh.position(mesh.from(h));
    return sum / mesh.valence(f);
}

/// Area over the surface's normal: folded parts count negative.
inline double signed_area(const Prepared& p) {
    double sum = 0.0;
    for (const Face f : faces(p.mesh))
        sum += 0.5 * doubled_area(p.mesh, f).dot(p.reference.closest(centre(p.mesh, f), p.mesh.info(f).patch).normal);
    return sum;
}

/// Area of the input triangles.
inline double input_area(const shapes::Shape& shape) {
    double sum = 0.0;
    for (const auto& t : shape.triangles) {
        const auto at = [&](std::size_t k) -> const Point& { return shape.points[static_cast<std::size_t>(t[k])]; };
        sum += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    return sum;
}

/// Number of triangles that are turned over, against the surface's normal.
inline int inverted_triangles(const Prepared& p) {
    int n = 0;
    for (const Face f : faces(p.mesh)) {
        if (p.mesh.is_triangle(f)) n += doubled_area(p.mesh, f).dot(p.reference.closest(centre(p.mesh, f)).normal) <= 0.0;
    }
    return n;
}

/// What no stage may break.
inline void expect_sound(const Prepared& p) {
    EXPECT_TRUE(validate(p.mesh).empty()) << validate(p.mesh).front();
    EXPECT_TRUE(topology(p.mesh) == p.before);
}

/// Every edge of the path is an edge of the mesh that lies on a feature line.
inline void expect_covered(const SurfaceMesh& mesh, const std::vector<std::int32_t>& path_of_input) {
    for (std::size_t i = 0; i + 1 < path_of_input.size(); ++i) {
        const HalfEdge h = mesh.find_halfedge(Vertex(path_of_input[i]), Vertex(path_of_input[i + 1]));
        ASSERT_TRUE(h.is_valid());
        EXPECT_GE(mesh.info(SurfaceMesh::edge(h)).line, 0);
    }
}

}  // namespace anisoquad::stages
