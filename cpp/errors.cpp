#include "errors.h"

namespace anisoquad {

std::string_view name(ErrorCode code) {
    switch (code) {
        case ErrorCode::empty_mesh: return "empty_mesh";
        case ErrorCode::non_finite_coordinates: return "non_finite_coordinates";
        case ErrorCode::index_out_of_range: return "index_out_of_range";
        case ErrorCode::degenerate_facets: return "degenerate_facets";
        case ErrorCode::duplicate_facets: return "duplicate_facets";
        case ErrorCode::non_manifold_edges: return "non_manifold_edges";
        case ErrorCode::non_manifold_vertices: return "non_manifold_vertices";
        case ErrorCode::inconsistent_orientation: return "inconsistent_orientation";
        case ErrorCode::invalid_source: return "invalid_source";
        case ErrorCode::invalid_feature_edge: return "invalid_feature_edge";
        case ErrorCode::invalid_option: return "invalid_option";
        case ErrorCode::cancelled: return "cancelled";
        case ErrorCode::not_meshable: return "not_meshable";
        case ErrorCode::invalid_shape: return "invalid_shape";
        case ErrorCode::shape_mismatch: return "shape_mismatch";
        case ErrorCode::face_not_meshable: return "face_not_meshable";
    }
    return "unknown";
}

std::string_view name(ElementKind kind) {
    switch (kind) {
        case ElementKind::none: return "none";
        case ElementKind::vertex: return "vertex";
        case ElementKind::edge: return "edge";
        case ElementKind::facet: return "facet";
        case ElementKind::cad_face: return "cad_face";
        case ElementKind::cad_edge: return "cad_edge";
    }
    return "unknown";
}

}  // namespace anisoquad
