#pragma once

#include <string>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// What the connectivity of a surface must keep through all stages (method, "Invariants").
struct Topology {
    std::int32_t components = 0;
    std::int32_t boundary_loops = 0;
    std::int32_t euler_characteristic = 0;
    bool operator==(const Topology&) const = default;
};

Topology topology(const SurfaceMesh& mesh);

/// Checks the half-edge structure: twins, loops, faces with three or four distinct nodes, boundary handles, duplicate faces,
/// two edges between the same nodes. Quads that share two edges at a node of valence two (doublets) are not defects.
/// @returns one line per defect, at most `most`; empty = valid
std::vector<std::string> validate(const SurfaceMesh& mesh, std::size_t most = 10);

}  // namespace anisoquad
