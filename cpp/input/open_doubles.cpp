#include "input/open_doubles.h"

#include <algorithm>
#include <vector>

#include "input/weld_points.h"

namespace anisoquad {

std::int32_t count_open_doubles(const SurfaceMesh& mesh) {
    std::vector<std::int32_t> index(static_cast<std::size_t>(mesh.vertex_slots()), -1);
    TriangleSoup soup;
    std::vector<char> is_open;
    const auto index_of = [&](Vertex v) {
        std::int32_t& i = index[static_cast<std::size_t>(v.index())];
        if (i < 0) {
            i = soup.add_vertex(mesh.position(v), v.index());
            is_open.push_back(mesh.is_boundary(v) ? 1 : 0);
        }
        return i;
    };
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
        if (!mesh.is_boundary(HalfEdge(i))) continue;
        const HalfEdge h = SurfaceMesh::twin(HalfEdge(i));
        soup.triangles.push_back({index_of(mesh.from(h)), index_of(mesh.to(h)), index_of(mesh.to(mesh.next(h)))});
    }
    if (soup.triangles.empty()) return 0;
    const std::vector<std::int32_t> place = points_at_one_place(soup);
    std::vector<std::int32_t> open_at(place.size(), 0);
    for (std::size_t v = 0; v < place.size(); ++v) open_at[static_cast<std::size_t>(place[v])] += is_open[v];
    std::int32_t doubles = 0;
    for (const std::int32_t open : open_at) doubles += std::max(0, open - 1);
    return doubles;
}

}  // namespace anisoquad
