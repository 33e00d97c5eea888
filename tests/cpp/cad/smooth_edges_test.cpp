#include "cad/smooth_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cad_shapes.h"

namespace anisoquad::cad {
namespace {

TEST(SmoothEdges, AreWhereFacesGoOnIntoEachOther) {
    const CadShape stadium = shapes::stadium();
    const std::vector<char> smooth = smooth_edges(stadium, 1.0);
    for (std::size_t e = 0; e < smooth.size(); ++e) {
        const CadEdge& edge = stadium.edges()[e];
        const Eigen::Vector3d way = stadium.vertex(edge.vertex[1]) - stadium.vertex(edge.vertex[0]);
        EXPECT_EQ(smooth[e] != 0, std::abs(way.z()) > 0.5) << "the upright ones are those between the flat and the round sides";
    }
}

TEST(SmoothEdges, AreNoneOfABoxUnlessTheAngleIsLarge) {
    const CadShape box = shapes::box();
    const std::vector<char> none = smooth_edges(box, 89.0);
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
    const std::vector<char> all = smooth_edges(box, 91.0);
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), 12);
}

TEST(SmoothEdges, SeamsAndPolesAreNot) {
    for (const char smooth : smooth_edges(shapes::sphere(), 180.0)) EXPECT_EQ(smooth, 0);
}

}  // namespace
}  // namespace anisoquad::cad
