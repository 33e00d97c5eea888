#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/edge_paths.h"
#include "cad/shape.h"
#include "cad/triangle_origin.h"

namespace anisoquad::cad {

enum class EntityKind : std::uint8_t { face, edge, vertex };

/// What of the shape a mesh vertex lies on: the least of vertex, edge, face.
struct Entity {
    EntityKind kind = EntityKind::face;
    std::int32_t index = -1;  ///< -1: the vertex is in no triangle
};

/// How a triangulation lies on a shape.
struct MeshLink {
    std::vector<Eigen::Vector3d> points;                          ///< the mesh's vertices, each moved onto what it lies on
    std::vector<Entity> entity;                                   ///< per vertex
    std::vector<std::int32_t> facet_face;                         ///< per triangle: its CAD face
    std::vector<std::array<Eigen::Vector2d, 3>> facet_parameter;  ///< per triangle: of its corners on its face
    std::vector<EdgePath> paths;                                  ///< per CAD edge, see find_edge_paths()
};

struct LinkOptions {
    double on_edge = 0.02;  ///< largest distance of a vertex from its CAD edge, over the mesh edge that leads there
    double on_face = 0.25;  ///< the same from its CAD face, over the mean length of its edges
};

/// Finds what each vertex and triangle of a triangulation of a shape lies on: CAD edges are followed over the mesh, the triangles
/// between them belong to the face that those edges bound, and parameters are found by walking from triangle to triangle.
/// @param known what of it needs no search
/// @throws Error of check_input(); Error{shape_mismatch} with the vertices that are off the shape, or the CAD edges that the mesh
/// does not follow;
///         Error{face_not_meshable} with CAD faces on which the mesh has no triangle
MeshLink link_mesh(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles,
                   const TriangleOrigin& known = {}, const LinkOptions& options = {});

}  // namespace anisoquad::cad
