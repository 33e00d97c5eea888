#pragma once

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// Writes VertexInfo::size of all nodes of unmeshed triangles: the side of the square that is as large as two triangles there, so
/// that quads of this size keep the triangles' density of nodes (half as many elements, paper 3).
void assign_node_sizes(SurfaceMesh& mesh);

}  // namespace anisoquad
