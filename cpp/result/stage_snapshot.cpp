#include "result/stage_snapshot.h"

#include <utility>

#include "mesh/arrays.h"

namespace anisoquad {

StageSnapshot snapshot_of(const SurfaceMesh& mesh, const WorkingInput& input, const std::string& name) {
    StageSnapshot stage;
    stage.name = name;
    MeshArrays arrays = to_arrays(mesh);
    for (const Vertex v : arrays.vertices) stage.points.push_back(input.place_of(mesh, v));
    stage.faces = std::move(arrays.faces);
    for (const Face f : arrays.face_handles) stage.row.push_back(mesh.info(f).row);
    return stage;
}

}  // namespace anisoquad
