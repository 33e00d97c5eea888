#include "anisotropy/merge.h"

#include "mesh/euler_operators.h"

namespace anisoquad {

using M = SurfaceMesh;

void merge_rows(SurfaceMesh& mesh, RowStack& stack, const std::vector<char>& kept) {
    const std::size_t ends = stack.layers[0].size();
    const std::size_t last = stack.closed ? ends - 1 : ends;  // a closed layer names its first node twice
    for (std::size_t j = 1; j < stack.layers.size(); ++j) {
        for (std::size_t i = 0; i < last; ++i) {
            if (!kept[i]) dissolve_edge(mesh, M::edge(mesh.find_halfedge(stack.layers[j - 1][i], stack.layers[j][i])));
        }
    }
    for (std::size_t j = 1; j + 1 < stack.layers.size(); ++j) {
        for (std::size_t i = 0; i < last; ++i) {
            if (!kept[i]) dissolve_vertex(mesh, M::twin(mesh.halfedge(stack.layers[j][i])));
        }
    }
    for (std::size_t j = 0; j + 1 < stack.layers.size(); ++j) {
        std::vector<Vertex> nodes;
        for (std::size_t i = 0; i < ends; ++i) {
            if (kept[i]) nodes.push_back(stack.layers[j][i]);
        }
        stack.layers[j] = std::move(nodes);
    }
    // A stack without rows has only the source, which merge_source_nodes() thins out.
    if (stack.layers.size() == 1) {
        std::vector<Vertex> nodes;
        for (std::size_t i = 0; i < ends; ++i) {
            if (kept[i]) nodes.push_back(stack.layers[0][i]);
        }
        stack.layers[0] = std::move(nodes);
    }
}

namespace {

/// Collapses the node into the neighbour on the source that is given; triangles beside vanish.
bool collapse_along(SurfaceMesh& mesh, Vertex node, Vertex neighbour) {
    const HalfEdge h = mesh.find_halfedge(node, neighbour);
    if (!h.is_valid() || !is_collapse_ok(mesh, h)) return false;
    collapse(mesh, h);
    return true;
}

/// Splits the edges between the node and those of its neighbours that are the given one's too without a triangle on all three:
/// only so far as triangles are beside them, they would come to lie on each other.
bool loosen(SurfaceMesh& mesh, Vertex node, Vertex neighbour) {
    const HalfEdge h = mesh.find_halfedge(node, neighbour);
    if (!h.is_valid()) return false;
    std::vector<Edge> tight;
    for (const HalfEdge out : mesh.outgoing(node)) {
        const Vertex w = mesh.to(out);
        if (w == neighbour || !mesh.find_halfedge(w, neighbour).is_valid()) continue;
        const auto beside = [&](HalfEdge side) {
            return !mesh.is_boundary(side) && mesh.is_triangle(mesh.face(side)) && mesh.to(mesh.next(side)) == w;
        };
        if (beside(h) || beside(M::twin(h)) || mesh.is_constrained(M::edge(out))) continue;
        if (mesh.is_triangle(mesh.face(out)) && mesh.is_triangle(mesh.face(M::twin(out)))) tight.push_back(M::edge(out));
    }
    for (const Edge e : tight) {
        const HalfEdge k = M::halfedge(e);
        split_edge(mesh, e, 0.5 * (mesh.position(mesh.from(k)) + mesh.position(mesh.to(k))));
    }
    return !tight.empty();
}

/// A node between two edges that every face at it can do without; at the tip of a triangle it can not.
bool is_dissolvable(const SurfaceMesh& mesh, Vertex node) {
    if (mesh.valence(node) != 2) return false;
    for (const HalfEdge h : mesh.outgoing(node)) {
        if (!mesh.is_boundary(h) && mesh.is_triangle(mesh.face(h))) return false;
    }
    return true;
}

}  // namespace

int merge_source_nodes(SurfaceMesh& mesh, const std::vector<Vertex>& nodes, const std::vector<char>& kept) {
    int failed = 0;
    const std::size_t n = nodes.size();
    for (std::size_t first = 0; first < n;) {
        std::size_t last = first + 1;
        while (last < n && !kept[last]) ++last;
        if (last >= n) break;
        // Nodes of the first half go to the segment's start, the others to its end, from the middle outwards being last.
        const std::size_t middle = (first + last + 1) / 2;
        for (std::size_t i = first + 1; i < last; ++i) {
            const std::size_t k = i < middle ? i : last + middle - 1 - i;
            if (is_dissolvable(mesh, nodes[k])) {
                dissolve_vertex(mesh, M::twin(mesh.halfedge(nodes[k])));
                continue;
            }
            const Vertex near = k < middle ? nodes[first] : nodes[last];
            const Vertex far = k < middle ? nodes[last] : nodes[first];
            const bool merged = collapse_along(mesh, nodes[k], near) || collapse_along(mesh, nodes[k], far) ||
                                (loosen(mesh, nodes[k], near) && collapse_along(mesh, nodes[k], near)) ||
                                (loosen(mesh, nodes[k], far) && collapse_along(mesh, nodes[k], far));
            if (!merged) ++failed;
        }
        first = last;
    }
    return failed;
}

}  // namespace anisoquad
