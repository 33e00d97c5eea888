#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cad/edge_paths.h"

namespace anisoquad::cad {

/// Which CAD edge each mesh edge lies on, if any, by its two vertices.
class PathEdges {
  public:
    struct Side {
        std::int32_t edge = -1;    ///< CAD edge
        double parameter[2] = {};  ///< at the two vertices that were asked for, in their order
    };
    explicit PathEdges(std::span<const EdgePath> paths);
    /// @returns Side with edge -1 where the mesh edge lies on no CAD edge
    Side find(std::int32_t a, std::int32_t b) const;

  private:
    struct Entry {
        std::int32_t low, high, edge;
        double at_low, at_high;
    };
    std::vector<Entry> entries_;
};

/// The triangles across the three edges of each, from corner k to k+1; -1 = none.
std::vector<std::array<std::int32_t, 3>> facet_neighbours(Triangles triangles);

/// Finds the CAD face of every triangle. Regions are the triangles that paths of border edges separate; a region's face is the
/// one that has all CAD edges round it, the nearest where there are several.
/// @throws Error{shape_mismatch} where there is none, Error{face_not_meshable} where a face gets no triangle
std::vector<std::int32_t> find_facet_faces(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles,
                                           std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                           std::span<const EdgePath> paths);

}  // namespace anisoquad::cad
