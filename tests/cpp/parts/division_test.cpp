#include "parts/division.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/feature_lines.h"
#include "features/patches.h"
#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

/// Faces as sorted places of their nodes, with their patch.
std::vector<std::vector<double>> content(const SurfaceMesh& mesh) {
    std::vector<std::vector<double>> all;
    for (std::int32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_deleted(Face(i))) continue;
        std::vector<std::vector<double>> corners;
        for (const HalfEdge h : mesh.halfedges(Face(i))) {
            const Point& p = mesh.position(mesh.from(h));
            corners.push_back({p.x(), p.y(), p.z(), static_cast<double>(mesh.info(mesh.from(h)).input),
                               static_cast<double>(mesh.info(M::edge(h)).line)});
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::vector<double>& face = all.emplace_back(1, mesh.info(Face(i)).patch);
        for (const auto& c : corners) face.insert(face.end(), c.begin(), c.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

struct Divided {
    SurfaceMesh mesh;
    std::vector<Part> parts;

    template <class Rule>
    Divided(const shapes::Shape& shape, std::int32_t count, Rule part_of) : mesh(shape.mesh()) {
        find_features(mesh, {}, {});
        find_patches(mesh);
        std::vector<std::int32_t> part;
        for (std::int32_t f = 0; f < mesh.face_slots(); ++f) part.push_back(part_of(f));
        Division division(mesh, part, count);
        for (std::int32_t i = 0; i < count; ++i) {
            parts.push_back(division.take(i));
            EXPECT_EQ(parts.back().mesh.face_count(), division.face_count(i));
        }
    }
    SurfaceMesh joined() const { return join(parts, mesh.vertex_slots(), mesh.edge_slots()); }
    std::int32_t cut_edges(std::size_t part) const {
        const SurfaceMesh& mine = parts[part].mesh;
        std::int32_t n = 0;
        for (std::int32_t e = 0; e < mine.edge_slots(); ++e) {
            n += mine.info(Edge(e)).cut;
            EXPECT_TRUE(!mine.info(Edge(e)).cut || mine.is_boundary(Edge(e)));
        }
        return n;
    }
};

void expect_same_again(const Divided& divided) {
    for (const Part& part : divided.parts) EXPECT_TRUE(validate(part.mesh).empty());
    const SurfaceMesh again = divided.joined();
    EXPECT_TRUE(validate(again).empty());
    EXPECT_EQ(topology(again), topology(divided.mesh));
    EXPECT_EQ(content(again), content(divided.mesh));
    for (std::int32_t e = 0; e < again.edge_slots(); ++e) EXPECT_FALSE(again.info(Edge(e)).cut);
}

TEST(Division, PartsMakeTheSameMeshAgain) {
    const Divided halves(shapes::grid(6, 4), 2, [](std::int32_t f) { return f % 12 < 6 ? 0 : 1; });
    EXPECT_EQ(halves.cut_edges(0), 4);
    EXPECT_EQ(halves.cut_edges(1), 4);
    expect_same_again(halves);
    expect_same_again({shapes::sphere(12, 8), 3, [](std::int32_t f) { return f % 3; }});
    expect_same_again({shapes::torus(9, 7), 2, [](std::int32_t f) { return f / 63; }});
    expect_same_again({shapes::cube(3), 1, [](std::int32_t) { return 0; }});
    expect_same_again(
        {shapes::grid(3, 3), 4, [](std::int32_t f) { return f == 5 ? 3 : f % 2; }});  // one is empty, one a triangle
}

TEST(Division, BordersOnLinesAreCutsTooButNotThoseOfTheWhole) {
    const Divided cube(shapes::cube(2), 6, [](std::int32_t f) { return f / 8; });
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(cube.cut_edges(i), 8);
    expect_same_again(cube);
}

TEST(Division, WhereAPartTouchesItselfANodeComesOncePerFan) {
    // The cells of one colour of a chessboard.
    const Divided chess(shapes::grid(2, 2), 2, [](std::int32_t f) { return f / 2 == 0 || f / 2 == 3 ? 0 : 1; });
    EXPECT_EQ(chess.parts[0].mesh.vertex_count(), 8);
    EXPECT_EQ(std::count(chess.parts[0].vertices.begin(), chess.parts[0].vertices.end(), Vertex(4)), 2);
    expect_same_again(chess);
}

TEST(Division, WhatChangesInsideAPartIsKept) {
    Divided halves(shapes::grid(6, 4), 2, [](std::int32_t f) { return f % 12 < 6 ? 0 : 1; });
    SurfaceMesh& part = halves.parts[1].mesh;
    for (std::int32_t v = 0; v < part.vertex_slots(); ++v) {
        if (!part.is_boundary(Vertex(v))) part.position(Vertex(v)).z() = 7.0;
    }
    const SurfaceMesh again = halves.joined();
    int lifted = 0;
    for (std::int32_t v = 0; v < again.vertex_slots(); ++v) lifted += again.position(Vertex(v)).z() == 7.0;
    EXPECT_EQ(lifted, 2 * 3);
    EXPECT_EQ(topology(again), topology(halves.mesh));
}

}  // namespace
}  // namespace anisoquad
