#pragma once

#include <cstdint>

#include "mesh/surface_mesh.h"
#include "surface/reference_surface.h"

namespace anisoquad {

/// What optimise_node() makes as good as it can.
enum class Aim {
    worst_element,
    /// Up to Star::kPoor, the worst corner that a place of the node can open: a corner opposite it, between two lines at a small
    /// angle, does not hide that others are poor. The worst element does not get worse. (In the clean-up's trials, which judge by
    /// the worst element, it led to no better meshes.) Narrow stars are searched in steps as narrow; in those trials that let
    /// more replacements pass: 29 surfaces got a better 5th percentile (+.002) and a poorer worst quad (-.007).
    worst_changing_corner,
};

/// Moves a node so that the worst element round it gets better: a pattern search on the surface for the largest minimum scaled
/// Jacobian, after @cite freitag1997. Where an element is inverted the star is untangled first: the search is then for the
/// least sum of squares of what the corners lack of a small positive area, which is convex in a plane.
/// Nodes that move_node() must not move stay.
/// @param hint as in move_node()
/// @returns true if the node was moved
bool optimise_node(SurfaceMesh& mesh, Vertex v, const ReferenceSurface* reference = nullptr, std::int32_t* hint = nullptr,
                   Aim aim = Aim::worst_element);

}  // namespace anisoquad
