#include "result/collect_result.h"

#include <utility>

#include "mesh/arrays.h"

namespace anisoquad {

void collect_result(const SurfaceMesh& mesh, const WorkingInput& input, QuadMeshResult& result) {
    MeshArrays arrays = to_arrays(mesh);
    for (const Vertex v : arrays.vertices) {
        result.points.push_back(input.place_of(mesh, v));
        result.node_line.push_back(mesh.info(v).line);
        result.node_input.push_back(input.input_vertex(mesh.info(v).input));
    }
    result.quads = std::move(arrays.faces);
    for (const Face f : arrays.face_handles) {
        const FaceInfo& info = mesh.info(f);
        result.row.push_back(info.row);
        result.pass.push_back(info.pass);
        result.source.push_back(info.source);
        result.patch.push_back(info.patch);
    }
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (mesh.is_deleted(Edge(e)) || mesh.info(Edge(e)).line < 0) continue;
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        const auto point = [&](Vertex v) { return arrays.point_of_vertex[static_cast<std::size_t>(v.index())]; };
        result.line_edges.push_back({point(mesh.from(h)), point(mesh.to(h)), mesh.info(Edge(e)).line});
    }
}

}  // namespace anisoquad
