#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace anisoquad {

/// What is wrong with the user's input. `name()` gives the stable identifier that Python shows.
enum class ErrorCode {
    empty_mesh,
    non_finite_coordinates,
    index_out_of_range,
    degenerate_facets,
    duplicate_facets,
    non_manifold_edges,
    non_manifold_vertices,
    inconsistent_orientation,
    invalid_source,
    invalid_feature_edge,
    invalid_option,
    cancelled,
    not_meshable,
    invalid_shape,      ///< CAD: null, empty, broken or unreadable
    shape_mismatch,     ///< CAD: shape and mesh do not belong together
    face_not_meshable,  ///< CAD: no triangles can be made on a face
};

/// Which elements of the input the ids of an error count. Ids of CAD faces and edges are from 0: Face1 is 0.
enum class ElementKind { none, vertex, edge, facet, cad_face, cad_edge };

std::string_view name(ErrorCode code);
std::string_view name(ElementKind kind);

/// The typed error at the public door: what is wrong, where, and (in `what()`) what the user can do.
/// `ids` are indices of the input arrays: vertices, facets, or vertex pairs (two ids an edge).
class Error : public std::runtime_error {
  public:
    Error(ErrorCode code, const std::string& message, ElementKind kind = ElementKind::none, std::vector<std::int32_t> ids = {})
        : std::runtime_error(message), code_(code), kind_(kind), ids_(std::move(ids)) {}

    ErrorCode code() const { return code_; }
    ElementKind kind() const { return kind_; }
    const std::vector<std::int32_t>& ids() const { return ids_; }

  private:
    ErrorCode code_;
    ElementKind kind_;
    std::vector<std::int32_t> ids_;
};

}  // namespace anisoquad
