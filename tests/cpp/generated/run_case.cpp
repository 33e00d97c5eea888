#include "generated/run_case.h"

#include "errors.h"
#include "generated/result_check.h"
#include "input/repair.h"

namespace anisoquad::generated {
namespace {

/// The surface, lines and feature edges that quad_mesh() meshes after it has repaired its input.
MeshCase mended(MeshCase mesh_case) {
    RepairResult repaired =
        repair_surface(mesh_case.shape.points, mesh_case.shape.triangles, mesh_case.sources, mesh_case.options.feature_edges);
    mesh_case.shape = {std::move(repaired.points), std::move(repaired.triangles)};
    mesh_case.sources = std::move(repaired.sources);
    mesh_case.options.feature_edges = std::move(repaired.feature_edges);
    return mesh_case;
}

}  // namespace

Outcome run_case(const MeshCase& mesh_case) {
    Outcome outcome;
    try {
        const QuadMeshResult result =
            quad_mesh(mesh_case.shape.points, mesh_case.shape.triangles, mesh_case.sources, mesh_case.options);
        outcome.meshed = true;
        outcome.triangles = result.report.triangles_in;
        outcome.quads = static_cast<std::int32_t>(result.quads.size());
        outcome.inverted = result.report.inverted;
        const auto found = defects(mesh_case.options.repair ? mended(mesh_case) : mesh_case, result);
        if (!found.empty()) outcome.failure = found.front();
    } catch (const Error& error) {
        const bool about_lines = error.code() == ErrorCode::invalid_source || error.code() == ErrorCode::invalid_feature_edge;
        const bool about_surface =
            !about_lines && error.code() != ErrorCode::invalid_option && error.code() != ErrorCode::empty_mesh;
        // A repaired surface is valid, and so is what passed the checks; lines may be lost where a surface is mended, as those
        // on both sides of a slit that is welded.
        if (mesh_case.options.repair ? about_surface || (mesh_case.is_valid && !about_lines) : mesh_case.is_valid)
            outcome.failure = std::string("rejected: ") + error.what();
    } catch (const std::exception& error) {
        outcome.failure = error.what();
    }
    return outcome;
}

}  // namespace anisoquad::generated
