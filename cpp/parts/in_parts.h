#pragma once

#include <functional>

#include "context.h"
#include "parts/partition.h"

namespace anisoquad {

/// Works on the parts of a partition side by side, and puts them together again without deleted slots. A single part is worked on
/// in place. The result is the same for any number of threads.
/// @param work (mesh of a part, its cuts, its context); it keeps the boundary of its part as it is
/// @throws Error{cancelled}, and the mesh is not to be used any more
void in_parts(SurfaceMesh& mesh, const Partition& partition, Context& context,
              const std::function<void(SurfaceMesh&, const Cuts&, Context&)>& work);

}  // namespace anisoquad
