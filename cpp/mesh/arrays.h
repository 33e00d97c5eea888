#pragma once

#include <array>
#include <span>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Builds the half-edge mesh of a triangulation. Vertex i of the mesh is point i; face i is triangle i.
/// @param triangles consistently oriented and manifold (see input/check.h, which must have passed); unused points are
///        kept as isolated vertices
/// @throws Error{cancelled}
SurfaceMesh from_arrays(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                        const Context& context = no_context());

/// The mesh as arrays, without deleted and isolated elements, in the order of their slots.
struct MeshArrays {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 4>> faces;  ///< fourth index -1 for a triangle
    std::vector<Vertex> vertices;                    ///< handle of each point
    std::vector<Face> face_handles;                  ///< handle of each face
    std::vector<std::int32_t> point_of_vertex;       ///< per vertex slot, -1 = not written
};

/// @pre every face has three or four nodes
MeshArrays to_arrays(const SurfaceMesh& mesh);

}  // namespace anisoquad
