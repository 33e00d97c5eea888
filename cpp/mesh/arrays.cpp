#include "mesh/arrays.h"

#include "mesh/directed_edges.h"

namespace anisoquad {
SurfaceMesh from_arrays(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                        const Context& context) {
    SurfaceMesh mesh;
    const auto n = static_cast<std::int32_t>(points.size());
    const auto m = static_cast<std::int32_t>(triangles.size());
    mesh.reserve(n, 3 * m / 2 + 16, m);
    for (const Point& p : points) mesh.add_vertex(p);
    for (std::int32_t i = 0; i < n; ++i) mesh.info(Vertex(i)).input = i;

    context.breathe();
    const std::vector<DirectedEdge> edges = sorted_edges(points.size(), triangles);
    context.breathe();
    std::vector<HalfEdge> of_corner(edges.size());
    // Edges are numbered in the order of the facets, so that neighbours in the mesh are neighbours in memory.
    std::vector<std::int32_t> mate(edges.size(), -1);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        context.breathe_at(static_cast<std::int64_t>(i));
        if (edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high) {
            mate[static_cast<std::size_t>(edges[i].corner)] = edges[i + 1].corner;
            mate[static_cast<std::size_t>(edges[i + 1].corner)] = edges[i].corner;
            ++i;
        }
    }
    for (std::int32_t f = 0; f < m; ++f) {
        context.breathe_at(f);
        const Face face = mesh.add_face();
        const auto& t = triangles[static_cast<std::size_t>(f)];
        std::array<HalfEdge, 3> h;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = 3 * static_cast<std::size_t>(f) + k;
            if (!of_corner[corner].is_valid()) {
                of_corner[corner] = mesh.add_edge(Vertex(t[k]), Vertex(t[(k + 1) % 3]));
                if (mate[corner] >= 0) of_corner[static_cast<std::size_t>(mate[corner])] = SurfaceMesh::twin(of_corner[corner]);
            }
            h[k] = of_corner[corner];
            mesh.set_face(h[k], face);
            mesh.set_halfedge(Vertex(t[k]), h[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) mesh.link(h[k], h[(k + 1) % 3]);
        mesh.set_halfedge(face, h[0]);
    }
    context.breathe();
    mesh.link_boundary();
    return mesh;
}

MeshArrays to_arrays(const SurfaceMesh& mesh) {
    MeshArrays arrays;
    arrays.point_of_vertex.assign(static_cast<std::size_t>(mesh.vertex_slots()), -1);
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const Vertex v(i);
        if (mesh.is_deleted(v) || !mesh.halfedge(v).is_valid()) continue;
        arrays.point_of_vertex[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(arrays.points.size());
        arrays.points.push_back(mesh.position(v));
        arrays.vertices.push_back(v);
    }
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        const Face f(i);
        if (mesh.is_deleted(f)) continue;
        std::array<std::int32_t, 4> nodes{-1, -1, -1, -1};
        std::size_t k = 0;
        for (HalfEdge h : mesh.halfedges(f)) {
            assert(k < 4);
            nodes[k++] = arrays.point_of_vertex[static_cast<std::size_t>(mesh.from(h).index())];
        }
        arrays.faces.push_back(nodes);
        arrays.face_handles.push_back(f);
    }
    return arrays;
}

}  // namespace anisoquad
