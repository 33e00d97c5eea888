#include <array>

#include "cleanup/patterns.h"
#include "smoothing/move_node.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;
using Hexagon = std::array<Vertex, 6>;

/// Two quads, divided by the diagonal from corner k.
void add_divided(const std::vector<Face>& faces, const Hexagon& c, std::size_t k, std::vector<Proposal>& out) {
    Proposal& p = out.emplace_back();
    p.faces = faces;
    const auto at = [&](std::size_t i) { return c[(k + i) % 6]; };
    p.replacement.quads = {{at(0), at(1), at(2), at(3)}, {at(0), at(3), at(4), at(5)}};
}

/// Three quads round a new node that is joined to corners k, k + 2 and k + 4.
void add_centred(const SurfaceMesh& mesh, const std::vector<Face>& faces, const Hexagon& c, std::size_t k,
                 std::vector<Proposal>& out) {
    Proposal& p = out.emplace_back();
    p.faces = faces;
    Replacement::Node node;
    for (const Vertex v : c) {
        node.place += mesh.position(v) / 6.0;
        node.info.size += mesh.info(v).size / 6.0;
    }
    p.replacement.nodes.push_back(node);
    for (std::size_t i = k; i < k + 6; i += 2) {
        p.replacement.quads.push_back({Replacement::new_node(0), c[i % 6], c[(i + 1) % 6], c[(i + 2) % 6]});
    }
}

}  // namespace

void propose_hexagon(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out) {
    if (is_movable(mesh, v) && mesh.valence(v) == 3) {
        std::vector<Face> faces;
        Hexagon corners;
        std::size_t k = 0;
        HalfEdge h = mesh.halfedge(v);
        for (; k < 6; h = mesh.rotated_ccw(h)) {
            faces.push_back(mesh.face(h));
            corners[k++] = mesh.to(h);
            corners[k++] = mesh.to(mesh.next(h));
        }
        for (std::size_t i = 0; i < 3; ++i) add_divided(faces, corners, i, out);
        add_centred(mesh, faces, corners, 1, out);
    }
    for (const HalfEdge h : mesh.outgoing(v)) {
        if (is_fixed(mesh, M::edge(h))) continue;
        const HalfEdge g = M::twin(h);
        const Hexagon corners{mesh.from(h), mesh.to(mesh.next(g)), mesh.from(mesh.prev(g)),
                              mesh.to(h),   mesh.to(mesh.next(h)), mesh.from(mesh.prev(h))};
        const std::vector<Face> faces{mesh.face(h), mesh.face(g)};
        for (std::size_t i = 0; i < 2; ++i) add_centred(mesh, faces, corners, i, out);
    }
}

}  // namespace anisoquad
