#include "cad/edge_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cad/link_mesh.h"
#include "cad/triangulate.h"
#include "cad_shapes.h"
#include "errors.h"

namespace anisoquad::cad {
namespace {

std::set<std::int32_t> members(const std::vector<DirectedEdge>& chain) {
    std::set<std::int32_t> edges;
    for (const DirectedEdge& e : chain) edges.insert(e.edge);
    return edges;
}

TEST(TangentChain, RunsRoundAPlateWithRoundEnds) {
    const CadShape stadium = shapes::stadium();
    const std::int32_t straight = shapes::edge_of_length(stadium, 4.0);
    const auto chain = tangent_chain(stadium, straight, 5.0);
    ASSERT_EQ(chain.size(), 4u);
    EXPECT_EQ(members(chain).size(), 4u);
    const double z = stadium.vertex(stadium.edge(straight).vertex[0]).z();
    for (std::size_t i = 0; i < 4; ++i) {
        const CadEdge& edge = stadium.edge(chain[i].edge);
        EXPECT_EQ(stadium.vertex(edge.vertex[0]).z(), z);
        const CadEdge& next = stadium.edge(chain[(i + 1) % 4].edge);
        EXPECT_EQ(edge.vertex[chain[i].reversed ? 0 : 1], next.vertex[chain[(i + 1) % 4].reversed ? 1 : 0])
            << "each begins where the last ends";
    }
}

TEST(TangentChain, EndsAtCorners) {
    const CadShape box = shapes::box();
    for (std::int32_t e = 0; e < 12; ++e) EXPECT_EQ(tangent_chain(box, e, 15.0).size(), 1u);
    const CadShape cylinder = shapes::cylinder();
    EXPECT_EQ(tangent_chain(cylinder, shapes::edge_of_length(cylinder, 2.0 * M_PI), 15.0).size(), 1u);
    EXPECT_THROW(tangent_chain(box, 12, 15.0), Error);
}

TEST(PathOnEdges, JoinsEdgesGivenInAnyOrder) {
    const CadShape stadium = shapes::stadium();
    const Triangulation mesh = triangulate(stadium);
    const MeshLink link = link_mesh(stadium, mesh.points, mesh.triangles);
    const auto chain = tangent_chain(stadium, shapes::edge_of_length(stadium, 4.0), 5.0);
    const auto path =
        path_on_edges(stadium, link.paths, std::vector<std::int32_t>{chain[0].edge, chain[2].edge, chain[1].edge, chain[3].edge});
    EXPECT_EQ(path.front(), path.back());
    std::size_t edges = 0;
    for (const DirectedEdge& e : chain) edges += link.paths[static_cast<std::size_t>(e.edge)].vertices.size() - 1;
    EXPECT_EQ(path.size(), edges + 1);
    EXPECT_EQ(std::set<std::int32_t>(path.begin(), path.end()).size(), edges);

    const auto open = path_on_edges(stadium, link.paths, std::vector<std::int32_t>{chain[0].edge, chain[1].edge});
    auto back = path_on_edges(stadium, link.paths, std::vector<std::int32_t>{chain[0].edge, chain[1].edge}, true);
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(open, back);
    EXPECT_NE(open.front(), open.back());
}

TEST(PathOnEdges, RejectsWhatIsNotOneLine) {
    const CadShape stadium = shapes::stadium();
    const Triangulation mesh = triangulate(stadium);
    const MeshLink link = link_mesh(stadium, mesh.points, mesh.triangles);
    const auto chain = tangent_chain(stadium, shapes::edge_of_length(stadium, 4.0), 5.0);
    for (const std::vector<std::int32_t>& edges :
         {std::vector<std::int32_t>{chain[0].edge, chain[2].edge}, std::vector<std::int32_t>{}, std::vector<std::int32_t>{99}}) {
        try {
            path_on_edges(stadium, link.paths, edges);
            FAIL() << "was taken for one line";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_source);
        }
    }
}

}  // namespace
}  // namespace anisoquad::cad
