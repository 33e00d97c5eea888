#include "cleanup/patterns.h"

namespace anisoquad {

void propose_inset(const SurfaceMesh& mesh, Face f, std::vector<Proposal>& out) {
    std::array<Vertex, 4> corners;
    Point middle = Point::Zero();
    double size = 0.0;
    std::size_t n = 0;
    for (const HalfEdge h : mesh.halfedges(f)) {
        corners[n++] = mesh.from(h);
        middle += 0.25 * mesh.position(mesh.from(h));
        size += 0.25 * mesh.info(mesh.from(h)).size;
    }
    Proposal& p = out.emplace_back();
    p.faces = {f};
    for (std::size_t i = 0; i < 4; ++i) {
        Replacement::Node node;
        node.place = 0.5 * (mesh.position(corners[i]) + middle);
        node.info.size = size;
        p.replacement.nodes.push_back(node);
    }
    const auto inner = [](std::size_t i) { return Replacement::new_node(i % 4); };
    p.replacement.quads.push_back({inner(0), inner(1), inner(2), inner(3)});
    for (std::size_t i = 0; i < 4; ++i) p.replacement.quads.push_back({corners[i], corners[(i + 1) % 4], inner(i + 1), inner(i)});
}

}  // namespace anisoquad
