#include "anisotropy/raise_sizes.h"

#include <gtest/gtest.h>

#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

TEST(RaiseSizes, FallsOffWithDistanceAndStopsAtLines) {
    constexpr int n = 12;
    // A line along y = 6; the long edges are at its middle.
    Prepared p(shapes::grid(n, n), {source(path(6 * (n + 1), 6 * (n + 1) + n, 1), {})});
    for (const Vertex v : vertices(p.mesh)) p.mesh.info(v).size = 1.0;
    const auto node = [](int i, int j) { return Vertex(j * (n + 1) + i); };
    p.mesh.info(node(6, 8)).in_row = true;
    std::vector<double> length(static_cast<std::size_t>(p.mesh.vertex_slots()), 0.0);
    length[static_cast<std::size_t>(node(6, 6).index())] = 4.0;
    const std::vector<char> raised = raise_sizes(p.mesh, length);
    for (const Vertex v : vertices(p.mesh)) {
        const double way = (p.mesh.position(v) - p.mesh.position(node(6, 6))).norm();
        EXPECT_LE(p.mesh.info(v).size, std::max(1.0, 4.0 - kFallOff * way) + 1e-12);
        EXPECT_EQ(raised[static_cast<std::size_t>(v.index())] != 0, p.mesh.info(v).size > 1.0);
        if (p.mesh.info(v).kind != NodeKind::interior) {
            EXPECT_EQ(p.mesh.info(v).size, 1.0);
        }
    }
    EXPECT_DOUBLE_EQ(p.mesh.info(node(6, 7)).size, 4.0 - kFallOff);
    EXPECT_DOUBLE_EQ(p.mesh.info(node(6, 3)).size, 4.0 - 3.0 * kFallOff);
    EXPECT_DOUBLE_EQ(p.mesh.info(node(6, 8)).size, 1.0);  // of a row
}

}  // namespace
}  // namespace anisoquad
