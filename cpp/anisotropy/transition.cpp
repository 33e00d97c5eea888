#include "anisotropy/transition.h"

#include "mesh/euler_operators.h"

namespace anisoquad {

void give_back_top_row(SurfaceMesh& mesh, RowStack& stack) {
    const std::vector<Vertex> above = stack.layers.back();
    stack.layers.pop_back();
    stack.pass_of_row.pop_back();
    const std::vector<Vertex>& below = stack.layers.back();
    for (std::size_t s = 0; s + 1 < below.size(); ++s) {
        // The face is below[s], below[s+1], then the nodes above from right to left.
        HalfEdge base = mesh.find_halfedge(below[s], below[s + 1]);
        const int steps = mesh.valence(mesh.face(base)) - 3;  // edges above
        const auto clear = [&](HalfEdge h) { mesh.info(mesh.face(h)) = FaceInfo{mesh.info(mesh.face(h)).patch, 0, 0, -1}; };
        // Right half: triangles at below[s+1]; then the middle one over the merged edge; then triangles at below[s].
        const int right = steps / 2;
        for (int i = 0; i < right; ++i) {
            const HalfEdge at_right = mesh.next(base);  // below[s+1] → first node above
            const HalfEdge cut = insert_edge(mesh, at_right, mesh.next(mesh.next(at_right)));
            clear(SurfaceMesh::twin(cut));
            clear(cut);
        }
        for (int i = right; i < steps; ++i) {
            const HalfEdge at_left = mesh.prev(base);  // first node above → below[s]
            const HalfEdge cut = insert_edge(mesh, base, mesh.prev(at_left));
            clear(SurfaceMesh::twin(cut));
            clear(cut);
        }
        clear(base);
    }
    for (const Vertex v : above) mesh.info(v).in_row = false;
}

}  // namespace anisoquad
