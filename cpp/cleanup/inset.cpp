#include <algorithm>

#include "cleanup/patterns.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// The quads again, smaller, inside of their outline, and a ring of quads round them.
void propose_inset_of(const SurfaceMesh& mesh, const std::vector<HalfEdge>& outline, std::vector<Face> faces,
                      std::vector<Proposal>& out) {
    Proposal& p = out.emplace_back();
    Point middle = Point::Zero();
    for (const HalfEdge h : outline) middle += mesh.position(mesh.from(h)) / static_cast<double>(outline.size());
    for (const HalfEdge h : outline) {
        Replacement::Node node;
        node.place = 0.5 * (mesh.position(mesh.from(h)) + middle);
        node.info.size = mesh.info(mesh.from(h)).size;
        p.replacement.nodes.push_back(node);
    }
    const auto inner = [&](Vertex v) {
        const auto at = std::find_if(outline.begin(), outline.end(), [&](HalfEdge h) { return mesh.from(h) == v; });
        return Replacement::new_node(static_cast<std::size_t>(at - outline.begin()));
    };
    for (const Face f : faces) {
        std::array<Vertex, 4> quad;
        std::size_t n = 0;
        for (const HalfEdge h : mesh.halfedges(f)) quad[n++] = inner(mesh.from(h));
        p.replacement.quads.push_back(quad);
    }
    for (const HalfEdge h : outline) {
        p.replacement.quads.push_back({mesh.from(h), mesh.to(h), inner(mesh.to(h)), inner(mesh.from(h))});
    }
    p.faces = std::move(faces);
}

}  // namespace

void propose_inset(const SurfaceMesh& mesh, Face f, std::vector<Proposal>& out) {
    std::vector<HalfEdge> outline;
    for (const HalfEdge h : mesh.halfedges(f)) outline.push_back(h);
    propose_inset_of(mesh, outline, {f}, out);
    for (const HalfEdge h : mesh.halfedges(f)) {
        if (is_fixed(mesh, M::edge(h))) continue;
        const HalfEdge g = M::twin(h);
        outline.clear();
        for (HalfEdge k = mesh.next(h); k != h; k = mesh.next(k)) outline.push_back(k);
        for (HalfEdge k = mesh.next(g); k != g; k = mesh.next(k)) outline.push_back(k);
        propose_inset_of(mesh, outline, {f, mesh.face(g)}, out);
    }
}

}  // namespace anisoquad
