#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Some faces of a mesh as a mesh of their own, without deleted slots. Its boundary is where it hangs together with the others
/// and must stay as it is: all else may change.
struct Part {
    SurfaceMesh mesh;
    std::vector<Vertex> vertices;  ///< per vertex slot, as divided: the vertex of the whole mesh
    std::vector<Edge> edges;       ///< per edge slot, as divided: the edge of the whole mesh
};

/// Takes parts out of a mesh. Reading only the mesh, parts may be taken side by side.
class Division {
  public:
    /// @param part_of_face per face slot, 0 … parts − 1; what belongs to deleted faces counts for nothing
    /// @throws Error{cancelled}
    Division(const SurfaceMesh& mesh, std::span<const std::int32_t> part_of_face, std::int32_t parts,
             const Context& context = no_context());

    std::int32_t count() const { return static_cast<std::int32_t>(first_.size()) - 1; }
    std::int32_t face_count(std::int32_t part) const { return first_[at(part) + 1] - first_[at(part)]; }
    /// The faces keep their order; vertices and edges follow them, so that neighbours are near each other in memory. A vertex
    /// at which the part touches itself comes once for each of its fans. Isolated vertices are in no part.
    Part take(std::int32_t part);

  private:
    static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
    bool is_inside(HalfEdge h, std::int32_t part) const;

    const SurfaceMesh& mesh_;
    std::span<const std::int32_t> part_of_face_;
    std::vector<std::int32_t> first_;  ///< of each part in faces_, and the end
    std::vector<Face> faces_;
    /// Per half-edge with a face what stands in its part for the vertex that it leaves; from when its face is taken, for itself.
    std::vector<std::int32_t> taken_;
};

/// The whole mesh again, part after part, without deleted slots.
/// @param parts all parts of one mesh; @param vertex_slots, edge_slots of that mesh
/// @throws Error{cancelled}
SurfaceMesh join(std::span<const Part> parts, std::int32_t vertex_slots, std::int32_t edge_slots,
                 const Context& context = no_context());

}  // namespace anisoquad
