#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/surface_mesh.h"

namespace anisoquad {

/// The structured rows on one side of one source. Seen along the nodes, the rows lie on the left; for the right side of a source
/// the nodes run against its direction.
struct RowStack {
    std::int32_t source = 0;
    bool left = true;                         ///< side of the source, seen along the source's direction
    bool goes_on = false;                     ///< the stack that follows was cut off this one
    bool closed = false;                      ///< a closed source: the last node of every layer is its first
    std::vector<std::vector<Vertex>> layers;  ///< layers[0]: the source; layers[j]: top nodes of row j (1-based)
    std::vector<std::int32_t> pass_of_row;    ///< [j − 1]: pass that built row j
    std::size_t rows_before = 0;              ///< rows when the running pass began
    bool is_running = false;                  ///< the running pass may begin one more row
    std::string stopped;                      ///< why the running pass began no further row
    std::vector<char> misfit;                 ///< per column: 1 where that row did not fit; empty: it did not as a whole

    std::size_t rows() const { return layers.size() - 1; }
    std::size_t columns() const { return layers[0].size() - 1; }
    const std::vector<Vertex>& top() const { return layers.back(); }
    /// Height of the uppermost row at column end i; 0 before the first row.
    double height(const SurfaceMesh& mesh, std::size_t i) const {
        if (rows() == 0) return 0.0;
        return (mesh.position(layers.back()[i]) - mesh.position(layers[rows() - 1][i])).norm();
    }
};

}  // namespace anisoquad
