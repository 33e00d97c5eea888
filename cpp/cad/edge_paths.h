#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/shape.h"

namespace anisoquad::cad {

using Triangles = std::span<const std::array<std::int32_t, 3>>;

/// The mesh vertices on one CAD edge, in the order of the edge's parameter, neighbours joined by mesh edges; a closed edge's
/// first is also the last. One vertex: the edge is shorter than the mesh can tell. Empty: the mesh does not follow the edge.
struct EdgePath {
    std::vector<std::int32_t> vertices;
    std::vector<double> parameters;  ///< of the edge's curve, ascending
};

/// Vertices that are joined to each vertex by a mesh edge, ascending, in one array.
class Neighbours {
  public:
    Neighbours(std::size_t vertices, Triangles triangles);
    std::span<const std::int32_t> of(std::int32_t v) const {
        return std::span(list_).subspan(first_[static_cast<std::size_t>(v)],
                                        first_[static_cast<std::size_t>(v) + 1] - first_[static_cast<std::size_t>(v)]);
    }

  private:
    std::vector<std::size_t> first_;
    std::vector<std::int32_t> list_;
};

struct EdgePaths {
    std::vector<EdgePath> paths;          ///< per CAD edge; degenerated ones have none
    std::vector<std::int32_t> at_vertex;  ///< per CAD vertex: the mesh vertex there, -1 = none
};

/// Follows the shape's edges over the mesh: from the mesh vertex at an edge's begin always to the next neighbour along the curve.
/// @param tolerance of a vertex off the curve, over the length of the mesh edge that leads to it
/// @param known paths per CAD edge that need not be found, where they are along mesh edges; empty: of none
EdgePaths find_edge_paths(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles, double tolerance,
                          std::span<const EdgePath> known = {});

}  // namespace anisoquad::cad
