#include <algorithm>

#include "cleanup/patterns.h"
#include "smoothing/move_node.h"

namespace anisoquad {

namespace {

constexpr std::size_t kMostSpokes =
    10;  ///< of a node that is split in all ways; the hub of a fan is only halved, or the proposals' cost is cubic

}  // namespace

void propose_vertex_split(const SurfaceMesh& mesh, Vertex v, std::vector<Proposal>& out) {
    if (!is_movable(mesh, v)) return;
    std::vector<HalfEdge> spokes;
    HalfEdge h = mesh.halfedge(v);
    do {
        spokes.push_back(h);
        h = mesh.rotated_ccw(h);
    } while (h != mesh.halfedge(v));
    const std::size_t n = spokes.size();
    if (n < 4) return;
    const Vertex first = Replacement::new_node(0);
    const Vertex second = Replacement::new_node(1);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n && j - i + 2 <= n; ++j) {
            if (n > kMostSpokes && j - i != n / 2) continue;
            Proposal& p = out.emplace_back();
            p.replacement.nodes.assign(2, {Point::Zero(), VertexInfo{}});
            for (Replacement::Node& node : p.replacement.nodes) node.info.size = mesh.info(v).size;
            for (std::size_t k = 0; k < n; ++k) {
                const bool between = k >= i && k < j;
                const HalfEdge s = spokes[k];
                p.faces.push_back(mesh.face(s));
                p.replacement.quads.push_back(
                    {between ? first : second, mesh.to(s), mesh.to(mesh.next(s)), mesh.from(mesh.prev(s))});
            }
            p.replacement.quads.push_back({first, mesh.to(spokes[j]), second, mesh.to(spokes[i])});
            for (std::size_t side = 0; side < 2; ++side) {
                Point sum = Point::Zero();
                const std::size_t from = side == 0 ? i : j;
                const std::size_t count = side == 0 ? j - i + 1 : n - (j - i) + 1;
                for (std::size_t k = 0; k < count; ++k) sum += mesh.position(mesh.to(spokes[(from + k) % n]));
                p.replacement.nodes[side].place = 0.5 * (mesh.position(v) + sum / static_cast<double>(count));
            }
        }
    }
}

}  // namespace anisoquad
