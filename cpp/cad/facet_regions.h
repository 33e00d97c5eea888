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
    /// @returns Side with edge -1 where the mesh edge lies on no CAD edge; the first where it lies on several
    Side find(std::int32_t a, std::int32_t b) const;
    /// Calls visit(CAD edge) for all: faces that are not sewn have each an edge of its own at one place.
    template <class Visit>
    void for_each(std::int32_t a, std::int32_t b, const Visit& visit) const {
        for (std::size_t i = first(a, b); i < entries_.size() && entries_[i].joins(a, b); ++i) visit(entries_[i].edge);
    }

  private:
    struct Entry {
        std::int32_t low, high, edge;
        double at_low, at_high;
        bool joins(std::int32_t a, std::int32_t b) const { return std::minmax(a, b) == std::minmax(low, high); }
    };
    /// The first entry that is not before the mesh edge.
    std::size_t first(std::int32_t a, std::int32_t b) const;
    std::vector<Entry> entries_;
};

/// The triangles across the three edges of each, from corner k to k+1; -1 = none.
std::vector<std::array<std::int32_t, 3>> facet_neighbours(Triangles triangles);

/// Finds the CAD face of every triangle. Regions are the triangles that paths of border edges separate; a region's face is the
/// one that most of its triangles are known to be of, else one that has all CAD edges round it, the nearest where there are
/// several.
/// @param known per triangle: its CAD face, -1 = not known; empty: of none
/// @throws Error{shape_mismatch} where there is none, Error{face_not_meshable} where a face gets no triangle
std::vector<std::int32_t> find_facet_faces(const CadShape& shape, std::span<const Eigen::Vector3d> points, Triangles triangles,
                                           std::span<const std::array<std::int32_t, 3>> neighbours, const PathEdges& on_path,
                                           std::span<const EdgePath> paths, std::span<const std::int32_t> known = {});

}  // namespace anisoquad::cad
