#pragma once

#include <functional>

#include "features/reference_lines.h"
#include "mesh/surface_mesh.h"
#include "surface/target_surface.h"

namespace anisoquad {

/// Slides a node of a feature line or boundary along it to where its star scores best (Star::Quality::score()) and no poor
/// element (Star::kPoor) is poorer than the worst one was. Only where the line is straight (the node and its two neighbours on it
/// are in line to within 1e-6 of their distance), so that the shape is kept exactly; the node stays between its neighbours.
/// Corners and nodes of anisotropic rows stay.
/// @returns true if the node was moved
bool slide_on_line(SurfaceMesh& mesh, Vertex v);

/// The same on a curved line, along the input's line, for nodes at poor elements (a wing's cap, where the nodes of the upper and
/// the lower line do not face each other). The edges beside the node stay within 4e-5 of the model's size of the line.
/// @param lines in the mesh's frame, in which the model's diagonal is 1
bool slide_on_curve(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines);

/// The same, for any aim: to where score(place) is best.
/// @param score what a place of the node is worth
bool slide_on_curve_towards(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines,
                            const std::function<double(const Point&)>& score);

/// The same on a line of a target, for every node: exactly on the target's curve, and edges beside the node may leave the line as
/// far as they do already.
/// @param target to which the input's lines belong
bool slide_on_target(SurfaceMesh& mesh, Vertex v, const ReferenceLines& lines, const FramedTarget& target);

}  // namespace anisoquad
