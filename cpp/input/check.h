#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "context.h"
#include "mesh/surface_mesh.h"
#include "options.h"

/// The checks at the public door. Errors list the indices of the offending elements of the input arrays (at most 1000) and
/// say in the user's words what to do.
namespace anisoquad {

/// Rejects what is not an oriented manifold triangulation: everything that from_arrays() and the later stages rely on.
/// Several components, open and closed surfaces and any genus are valid; so are points that no triangle uses.
/// @throws Error{empty_mesh, non_finite_coordinates, index_out_of_range, degenerate_facets, duplicate_facets,
///         non_manifold_edges, inconsistent_orientation, non_manifold_vertices}, looked for in this order; Error{cancelled}
void check_input(std::span<const Point> points, std::span<const std::array<std::int32_t, 3>> triangles,
                 const Context& context = no_context());

/// Rejects sources that are not paths of mesh edges, that touch themselves (but for a closed one's end) or each other
/// elsewhere than at nodes where both end, and passes with a ratio below 1 or fewer than 0 rows.
/// @param mesh fresh from from_arrays() @param rank the mesh's vertex that each input vertex is; empty: the one of the same id
/// @throws Error{invalid_source, invalid_option}
void check_sources(const SurfaceMesh& mesh, std::span<const Source> sources, std::span<const std::int32_t> rank = {});

/// Rejects options out of their range, and sizes per vertex that are not one for each of the points.
/// @throws Error{invalid_option}
void check_options(const Options& options, std::size_t points = 0);

/// Rejects pairs of vertices that are not edges of the mesh.
/// @param mesh fresh from from_arrays() @param rank the mesh's vertex that each input vertex is; empty: the one of the same id
/// @throws Error{invalid_feature_edge}
void check_feature_edges(const SurfaceMesh& mesh, std::span<const std::array<std::int32_t, 2>> edges,
                         std::span<const std::int32_t> rank = {});

}  // namespace anisoquad
