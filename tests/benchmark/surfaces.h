#pragma once

#include <string>

#include "wing_file.h"

namespace anisoquad::benchmarks {

using Surface = WingFile;

/// Unit square of about so many triangles, regular but for a fifth of the spacing by which its nodes are displaced.
Surface plane(int triangles);
/// Unit sphere, made from an icosahedron's faces divided evenly.
Surface sphere(int triangles);
/// Wing of tests/data, its triangles cut into four until there are at least so many.
Surface wing(const std::string& name, int triangles);

}  // namespace anisoquad::benchmarks
