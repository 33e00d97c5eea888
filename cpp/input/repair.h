#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/surface_mesh.h"
#include "options.h"
#include "quality/repair_report.h"

namespace anisoquad {

/// The mended surface. Vertices keep the input's indices, new ones follow; vertices that no facet uses any more stay.
struct RepairResult {
    std::vector<Point> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> origin;  ///< per point: input vertex at its place, -1 = none
    std::vector<Source> sources;       ///< the same lines on the mended surface
    std::vector<std::array<std::int32_t, 2>> feature_edges;
    RepairReport report;
};

/// Mends what can be mended of a surface that check_input() would reject: facets out of range, at vertices that are not
/// finite, without area, or doubled are dropped or collapsed (what they leave open becomes boundary); vertices at one place are
/// welded where the surface is open; edges with three or more facets and one-sided surfaces are cut apart; facets are turned
/// to one orientation, outwards where the surface is closed; vertices that join parts without an edge are doubled.
/// A surface that is valid and oriented outwards is left as it is, but for welding open edges that lie on each other.
/// @returns triangles that check_input() accepts, unless none are left
RepairResult repair_surface(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                            std::span<const Source> sources = {},
                            std::span<const std::array<std::int32_t, 2>> feature_edges = {});

/// What was changed, in the user's words: "3 facets turned, 12 vertices welded"; empty if nothing was.
std::string summary(const RepairReport& report);

}  // namespace anisoquad
