#pragma once

#include "generated/byte_source.h"
#include "shapes.h"

namespace anisoquad::generated {

/// A surface of any kind, about 2 × 2 in size; it need not be valid (a piece cut out of another may be pinched).
shapes::Shape make_kind(ByteSource& source);

}  // namespace anisoquad::generated
