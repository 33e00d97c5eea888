#pragma once

#include <vector>

#include "cad/shape.h"

namespace anisoquad::cad {

/// Per CAD edge: 1 where the two faces beside it go on into each other smoothly: all along the edge their normals turn by no more
/// than an angle. Seams and poles are not.
/// @param angle degrees
std::vector<char> smooth_edges(const CadShape& shape, double angle);

}  // namespace anisoquad::cad
