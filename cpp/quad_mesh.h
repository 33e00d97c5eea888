#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "context.h"
#include "options.h"
#include "quality/report.h"
#include "surface/target_surface.h"

namespace anisoquad {

/// A copy of the mesh in mid-way, for pictures. Faces have three or four nodes (fourth = -1 for triangles).
struct StageSnapshot {
    std::string name;  ///< "prepare" (if triangles were remeshed), "pass 1: rows", "pass 1: merge", …, "fill", "result"
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 4>> faces;
    std::vector<std::int32_t> row;  ///< per face, 0 = not in a row
};

/// The all-quad mesh. `points` keeps the user's units; quads are oriented as the input.
struct QuadMeshResult {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 4>> quads;
    std::vector<std::int32_t> row;         ///< per quad: 1-based row counted from its source, 0 = not in a row
    std::vector<std::int32_t> pass;        ///< per quad: 1-based pass that built the row, 0 = not in a row
    std::vector<std::int32_t> source;      ///< per quad: index of the source, -1 = none
    std::vector<std::int32_t> patch;       ///< per quad: index of the patch
    std::vector<std::int32_t> node_line;   ///< per point: feature line it lies on, -1 = none
    std::vector<std::int32_t> node_input;  ///< per point: input vertex that it is, -1 = a new or moved point
    /// Mesh edges on feature lines as (node, node, line): covers every boundary and feature line of the input.
    std::vector<std::array<std::int32_t, 3>> line_edges;
    /// With a target only. Per quad: input triangle below its middle; per line edge: the input edge (vertex, vertex) that it is
    /// near.
    std::vector<std::int32_t> quad_facet;
    std::vector<std::array<std::int32_t, 2>> line_edge_input;
    Report report;
    std::vector<StageSnapshot> stages;  ///< filled when Options::record_stages
};

/// Meshes a triangulated surface with quadrilaterals: the whole way of the data (method: Merhof et al.).
/// @param points N coordinates, any unit; @param triangles M index triples, consistently oriented, manifold
/// @param sources lines of anisotropy (may be empty: isotropic Q-Morph everywhere)
/// @param target surface of which the triangles are a triangulation, with their vertices on it, or null: the nodes are brought
/// onto it
/// @throws Error for bad input (typed, with the ids of the elements) and when the context cancels
QuadMeshResult quad_mesh(std::span<const Eigen::Vector3d> points, std::span<const std::array<std::int32_t, 3>> triangles,
                         std::span<const Source> sources = {}, const Options& options = {}, Context& context = no_context(),
                         const TargetSurface* target = nullptr);

}  // namespace anisoquad
