#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "mesh/euler_operators.h"
#include "mesh/validate.h"
#include "shapes.h"
#include "surface/reference_surface.h"

/// All-quad meshes for the tests of the clean-up.
namespace anisoquad::shapes {

/// Quads in the plane z = 0, counter-clockwise; boundary edges lie on feature line 0, boundary nodes are fixed.
inline SurfaceMesh quad_mesh(const std::vector<Point>& points, const std::vector<std::array<std::int32_t, 4>>& quads) {
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (const auto& q : quads) {
        triangles.push_back({q[0], q[1], q[2]});
        triangles.push_back({q[0], q[2], q[3]});
    }
    SurfaceMesh mesh = from_arrays(points, triangles);
    for (const auto& q : quads) dissolve_edge(mesh, SurfaceMesh::edge(mesh.find_halfedge(Vertex(q[0]), Vertex(q[2]))));
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (!mesh.is_deleted(Face(i))) mesh.info(Face(i)).patch = 0;
    }
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        const Edge e(i);
        if (mesh.is_deleted(e) || !mesh.is_boundary(e)) continue;
        mesh.info(e).line = 0;
        for (const Vertex v : {mesh.from(SurfaceMesh::halfedge(e)), mesh.to(SurfaceMesh::halfedge(e))}) {
            mesh.info(v).kind = NodeKind::corner;
            mesh.info(v).line = 0;
        }
    }
    return mesh;
}

/// nx × ny unit quads; node (i, j) is j·(nx + 1) + i, the face at (i, j) is found by face_at().
inline SurfaceMesh quad_grid(int nx, int ny) {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 4>> quads;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) points.emplace_back(i, j, 0.0);
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const std::int32_t a = j * (nx + 1) + i;
            quads.push_back({a, a + 1, a + nx + 2, a + nx + 1});
        }
    }
    return quad_mesh(points, quads);
}

/// The plane that holds the grid.
inline ReferenceSurface plane(double nx, double ny) {
    const std::vector<Point> points{{0, 0, 0}, {nx, 0, 0}, {nx, ny, 0}, {0, ny, 0}};
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    return {points, triangles};
}

inline int irregular_inside(const SurfaceMesh& mesh) {
    int n = 0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (!mesh.is_deleted(v) && mesh.halfedge(v).is_valid() && !mesh.is_boundary(v) && mesh.valence(v) != 4) ++n;
    }
    return n;
}

inline std::string defects(const SurfaceMesh& mesh) {
    std::string text;
    for (const std::string& defect : validate(mesh)) text += defect + "; ";
    return text;
}

}  // namespace anisoquad::shapes
