#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// True for what the clean-up leaves alone: constrained edges and the edges of anisotropic rows.
inline bool is_fixed(const SurfaceMesh& mesh, Edge e) {
    if (mesh.is_constrained(e)) return true;
    return mesh.info(mesh.face(SurfaceMesh::halfedge(e, 0))).row > 0 || mesh.info(mesh.face(SurfaceMesh::halfedge(e, 1))).row > 0;
}

/// What a node inside a patch costs: 1, 3, 6, … for 1, 2, 3, … quads more or less than four; a doublet costs 5.
constexpr int irregularity(int quads) {
    const int d = quads < 4 ? 4 - quads : quads - 4;
    return d * (d + 1) / 2 + (quads == 2 ? 2 : 0);
}

/// How many quads belong round a node. The fixed edges divide its neighbourhood into sectors, and a sector of angle φ takes
/// max(1, round(φ / 90°)) quads; a node without fixed edges takes four. The angles are those at the time of construction:
/// fixed edges don't move in the clean-up.
class Sectors {
  public:
    Sectors(const SurfaceMesh& mesh, const ReferenceSurface& reference);

    struct Count {
        int quads = 0;
        int ideal = 4;
        float angle =
            0.0F;  ///< of the sector; 0: the whole neighbourhood of a node without fixed edges; −1: a part of a sector, cut

        /// As irregularity(), and more where two edges of a quad lie almost on one line, since nothing can smooth that away.
        int cost() const;
    };
    /// The sector of from(h) that holds face(h). @pre the face exists and is in no row
    Count count(const SurfaceMesh& mesh, HalfEdge h) const;
    /// Sum over the node's sectors outside of rows.
    int cost(const SurfaceMesh& mesh, Vertex v) const;

  private:
    std::vector<float> angle_;  ///< per half-edge: of the sector that it begins, counter-clockwise; 0 = none
};

}  // namespace anisoquad
