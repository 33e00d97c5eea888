#pragma once

#include <cstdint>

namespace anisoquad {

/// What the repair changed (Options::repair), by kind.
struct RepairReport {
    std::int32_t out_of_range_facets = 0;  ///< dropped: they named vertices that do not exist
    std::int32_t non_finite_facets = 0;    ///< dropped: a vertex of theirs has a coordinate that is not a finite number
    std::int32_t degenerate_facets = 0;    ///< collapsed or dropped: no area
    std::int32_t duplicate_facets = 0;     ///< dropped
    std::int32_t welded_vertices = 0;      ///< merged into another one at their place
    std::int32_t cut_edges = 0;            ///< of three or more facets, or where a one-sided surface was cut
    std::int32_t flipped_facets = 0;       ///< turned to the orientation of the rest, or outwards
    std::int32_t new_vertices = 0;         ///< so that parts that were joined at a vertex or cut apart have their own
    bool operator==(const RepairReport&) const = default;
};

}  // namespace anisoquad
