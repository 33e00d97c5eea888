#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "parts/cuts.h"

namespace anisoquad {

/// Which faces are worked on together.
struct Partition {
    std::vector<std::int32_t> part_of_face;  ///< per face slot, −1 = deleted
    std::int32_t parts = 0;
    std::vector<Cuts> cuts;  ///< per part: those that it was cut off by
    Cuts all_cuts;
};

/// A large mesh in halves, quarters…, cut across their longest extent. Parts are pieces of space with all patches in them, and
/// not patches: two that share two lines could otherwise join the same two nodes, each on its side. They depend on the mesh
/// alone, and not on the number of threads.
/// @param most faces of a part
/// @param is_start what is cut has such faces on both sides: from them the work begins
/// @throws Error{cancelled}
Partition make_partition(const SurfaceMesh& mesh, const std::function<bool(Face)>& is_start,
                         const Context& context = no_context(), std::int32_t most = 1 << 16);

}  // namespace anisoquad
