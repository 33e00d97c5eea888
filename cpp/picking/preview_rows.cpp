#include "picking/preview_rows.h"

#include "anisotropy/local_size.h"
#include "anisotropy/multi_pass.h"
#include "features/feature_lines.h"
#include "features/patches.h"
#include "input/check.h"
#include "mesh/arrays.h"
#include "qmorph/node_size.h"
#include "surface/reference_surface.h"

namespace anisoquad {

std::vector<RowEdge> preview_rows(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                                  std::span<const Source> sources, const Options& options) {
    check_options(options);
    check_input(points, triangles);
    SurfaceMesh mesh = from_arrays(points, triangles);
    check_sources(mesh, sources);
    find_features(mesh, sources, options);
    find_patches(mesh);
    std::vector<std::int32_t> patch;
    for (std::int32_t f = 0; f < mesh.face_slots(); ++f) patch.push_back(mesh.info(Face(f)).patch);
    const ReferenceSurface reference(points, triangles, patch, options.feature_angle);
    assign_node_sizes(mesh);
    build_anisotropic_rows(mesh, sources, LocalSize(points, triangles, reference), reference, options);

    std::vector<RowEdge> edges;
    const auto pass_beside = [&](HalfEdge h) { return mesh.is_boundary(h) ? 0 : mesh.info(mesh.face(h)).pass; };
    for (std::int32_t e = 0; e < mesh.edge_slots(); ++e) {
        if (mesh.is_deleted(Edge(e))) continue;
        const HalfEdge h = SurfaceMesh::halfedge(Edge(e));
        const std::int32_t pass = std::max(pass_beside(h), pass_beside(SurfaceMesh::twin(h)));
        if (pass > 0) edges.push_back({{mesh.position(mesh.from(h)), mesh.position(mesh.to(h))}, pass});
    }
    return edges;
}

}  // namespace anisoquad
