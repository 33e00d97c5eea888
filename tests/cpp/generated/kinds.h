#pragma once

#include "generated/byte_source.h"
#include "shapes.h"

namespace anisoquad::generated {

/// A surface of any kind, about 2 × 2 in size; it need not be valid (a piece cut out of another may be pinched).
/// @param extent 0 … 1: counts of cells along a side come up to this share of the largest
shapes::Shape make_kind(ByteSource& source, double extent);

}  // namespace anisoquad::generated
