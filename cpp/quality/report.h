#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quality/repair_report.h"

namespace anisoquad {

/// Distribution of one measure over the quads.
struct Distribution {
    double min = 0.0;
    double p5 = 0.0;
    double mean = 0.0;
    double p95 = 0.0;
    double max = 0.0;
    std::int32_t worst = -1;  ///< id of the worst quad
};

/// What one pass did on one side of a source (paper 3.2, 3.3), or on a part of the side where single columns were in the way.
struct PassReport {
    std::int32_t source = 0;  ///< index of the source
    std::int32_t pass = 0;    ///< 1-based
    std::string side;         ///< "left" or "right" of the source, seen along its direction
    std::int32_t ratio = 1;
    std::int32_t rows = 0;     ///< anisotropic rows that were kept
    std::int32_t columns = 0;  ///< quads per row before the merge
    std::string stopped;       ///< why no further row was begun, in the user's words
};

/// Quads of one row over all columns.
struct RowReport {
    std::int32_t source = 0;
    std::string side;
    std::int32_t row = 0;  ///< 1-based from the source
    std::int32_t pass = 0;
    std::int32_t quads = 0;
    double aspect_mean = 1.0;  ///< length along the source over height
    double height_mean = 0.0;  ///< in the user's units
};

struct StageTime {
    std::string stage;
    double seconds = 0.0;
};

/// Figures of a run, in the user's units.
struct Report {
    // counts
    std::int32_t triangles_in = 0;
    std::int32_t quads = 0;
    std::int32_t nodes = 0;
    std::int32_t triangles_left = 0;
    std::int32_t components = 0;
    std::int32_t patches = 0;
    std::int32_t feature_lines = 0;
    std::int32_t parity_splits = 0;
    std::int32_t inverted = 0;
    double reduction_percent = 0.0;  ///< 100·(1 − quads/triangles_in)
    std::int32_t euler_in = 0;
    std::int32_t euler_out = 0;
    // rows
    std::vector<PassReport> passes;
    std::vector<RowReport> rows;
    // quality
    Distribution scaled_jacobian;
    Distribution aspect_ratio;
    Distribution min_angle;  ///< degrees
    Distribution max_angle;  ///< degrees
    Distribution skew;
    Distribution warpage;  ///< degrees between the two halves' normals
    /// Smallest angle (degrees) between neighbouring feature edges of a patch: no quad there can have a scaled Jacobian above
    /// its sine. 180 when there is no feature corner.
    double sharpest_corner = 180.0;
    double scaled_jacobian_limit = 1.0;  ///< that sine, 1 when the corner is not below 90°
    /// Minimum over the quads that do not fill a feature corner whose angle alone keeps them below it.
    double scaled_jacobian_min_elsewhere = 0.0;
    double neighbour_area_ratio_p95 = 1.0;  ///< over the edges between rows and what follows them in the same patch
    double neighbour_area_ratio_max = 1.0;
    std::vector<std::int32_t> valence_histogram;  ///< interior nodes by number of edges
    double regular_percent = 0.0;                 ///< interior nodes with four edges
    double hausdorff = 0.0;                       ///< largest distance between mesh and input surface, both ways
    double hausdorff_relative = 0.0;              ///< over the diagonal of the bounding box
    RepairReport repair;  ///< what was changed before anything else; the counts above are of the mended surface
    std::vector<StageTime> times;
    std::vector<std::string> warnings;
};

}  // namespace anisoquad
