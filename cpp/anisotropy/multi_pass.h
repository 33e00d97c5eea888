#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "anisotropy/local_size.h"
#include "context.h"
#include "options.h"
#include "quality/report.h"

namespace anisoquad {

struct MultiPassResult {
    std::vector<PassReport> passes;
    std::vector<std::string> warnings;
};

/// Called after each step with its name ("pass 1: rows", "pass 1: merge").
using StageObserver = std::function<void(const std::string& stage)>;

/// The Multi-Pass Three-Step-Method (paper 3.2, 3.3): for each pass, rows on all sides of all sources in step, merge of all rows
/// from the source up, the uppermost row given back as triangles. The first pass starts from the source, every further one
/// from the top of the last anisotropic row; the anisotropies multiply.
///
/// Beyond the paper: where a few columns are in the way of the first rows of a pass (a feature line near the source, a corner at
/// its end), the rows go on beside them, see split_stack(). The source is merged only along edges that gained rows on a side.
/// After a source's last pass, unless that has a given number of rows, further rows get higher by up to 1.6 each until they are
/// nearly as high as wide: the size of elements changes smoothly over the end of the rows.
/// @pre sources checked, features found (the source's edges are constrained)
MultiPassResult build_anisotropic_rows(SurfaceMesh& mesh, std::span<const Source> sources, const LocalSize& size,
                                       const ReferenceSurface& reference, const Options& options,
                                       const StageObserver& observe = {}, Context& context = no_context());

}  // namespace anisoquad
