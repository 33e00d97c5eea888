#pragma once

#include <string>
#include <vector>

#include "generated/byte_source.h"
#include "options.h"
#include "quad_mesh.h"
#include "shapes.h"

namespace anisoquad::generated {

/// All that quad_mesh() is given.
struct MeshCase {
    shapes::Shape shape;
    std::vector<Source> sources;
    Options options;
    bool is_valid = false;  ///< passes all the checks at the door
};

/// A surface with sources and options, mostly of some dozen triangles.
/// @param may_be_bad the surface, the sources or the options may be what is to be rejected; larger surfaces are rarer then
MeshCase make_case(ByteSource& source, bool may_be_bad);

/// The surface as an OFF file, and sources and options behind it: to look at a case by other means.
std::string to_text(const MeshCase& mesh_case);

}  // namespace anisoquad::generated
