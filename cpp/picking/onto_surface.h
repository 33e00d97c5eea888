#pragma once

#include "picking/pick_surface.h"

namespace anisoquad {

/// Brings points onto the surface: those `on_line` to the nearest place of its feature lines and boundary, the others to the
/// nearest facet, corrected for the curvature as ReferenceSurface::project does.
/// @param on_line one entry a point
std::vector<Point> onto_surface(const PickSurface& surface, std::span<const Point> points, std::span<const bool> on_line);

}  // namespace anisoquad
