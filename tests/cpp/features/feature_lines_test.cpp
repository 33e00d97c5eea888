#include "features/feature_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "shapes.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

Source source(std::vector<std::int32_t> vertices) { return {std::move(vertices), {}, Sides::both}; }

int constrained_edges(const SurfaceMesh& mesh) {
    int n = 0;
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) n += mesh.info(Edge(i)).line >= 0;
    return n;
}

int corners(const SurfaceMesh& mesh) {
    int n = 0;
    for (std::int32_t i = 0; i < mesh.vertex_slots(); ++i) n += mesh.info(Vertex(i)).kind == NodeKind::corner;
    return n;
}

/// What must hold for the lines of any mesh.
void expect_consistent(const SurfaceMesh& mesh, const std::vector<FeatureLine>& lines) {
    int edges = 0;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const FeatureLine& line = lines[l];
        ASSERT_GE(line.nodes.size(), 2u);
        EXPECT_EQ(line.closed, line.nodes.front() == line.nodes.back());
        EXPECT_EQ(line.is_source, line.source >= 0);
        for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i) {
            const HalfEdge h = mesh.find_halfedge(line.nodes[i], line.nodes[i + 1]);
            ASSERT_TRUE(h.is_valid());
            EXPECT_EQ(mesh.info(M::edge(h)).line, static_cast<std::int32_t>(l));
            EXPECT_EQ(mesh.info(M::edge(h)).source, line.is_source);
            EXPECT_EQ(mesh.is_boundary(M::edge(h)), line.is_boundary);
            ++edges;
            if (i == 0) continue;
            EXPECT_EQ(mesh.info(line.nodes[i]).kind, NodeKind::line);
            EXPECT_EQ(mesh.info(line.nodes[i]).line, static_cast<std::int32_t>(l));
        }
        for (const Vertex v : {line.nodes.front(), line.nodes.back()}) {
            EXPECT_EQ(mesh.info(v).kind, line.closed && mesh.info(v).kind == NodeKind::line ? NodeKind::line : NodeKind::corner);
            EXPECT_GE(mesh.info(v).line, 0);
        }
    }
    EXPECT_EQ(edges, constrained_edges(mesh));  // no edge in two lines
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_boundary(Edge(i))) {
            EXPECT_GE(mesh.info(Edge(i)).line, 0);
        }
    }
}

TEST(FeatureLines, APlaneHasItsFourSides) {
    SurfaceMesh mesh = shapes::grid(5, 3).mesh();
    const auto lines = find_features(mesh, {}, {});
    expect_consistent(mesh, lines);
    EXPECT_EQ(lines.size(), 4u);
    EXPECT_EQ(corners(mesh), 4);
    for (const FeatureLine& line : lines) EXPECT_TRUE(line.is_boundary);
}

TEST(FeatureLines, ACubeHasTwelveEdgesAndEightCorners) {
    SurfaceMesh mesh = shapes::cube(3).mesh();
    const auto lines = find_features(mesh, {}, {});
    expect_consistent(mesh, lines);
    EXPECT_EQ(lines.size(), 12u);
    EXPECT_EQ(corners(mesh), 8);
    for (const FeatureLine& line : lines) EXPECT_FALSE(line.is_boundary);
}

TEST(FeatureLines, SmoothClosedSurfacesHaveNone) {
    for (const auto& shape : {shapes::sphere(24, 16), shapes::torus(40, 24)}) {
        SurfaceMesh mesh = shape.mesh();
        EXPECT_TRUE(find_features(mesh, {}, {}).empty());
        EXPECT_EQ(constrained_edges(mesh), 0);
    }
}

TEST(FeatureLines, ACylinderHasTwoClosedLinesWithoutCorners) {
    SurfaceMesh mesh = shapes::cylinder(16, 3).mesh();
    const auto lines = find_features(mesh, {}, {});
    expect_consistent(mesh, lines);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(lines[0].closed && lines[1].closed);
    EXPECT_EQ(corners(mesh), 0);
}

TEST(FeatureLines, TheAngleDecides) {
    for (const double turn : {30.0, 50.0, 120.0}) {
        SurfaceMesh mesh = shapes::roof(4, 2, turn).mesh();
        Options options;
        const auto lines = find_features(mesh, {}, options);
        expect_consistent(mesh, lines);
        const bool ridge = std::any_of(lines.begin(), lines.end(), [](const FeatureLine& line) { return !line.is_boundary; });
        EXPECT_EQ(ridge, turn > options.feature_angle);
        options.feature_angle = 125.0;
        EXPECT_EQ(constrained_edges(mesh), 16 + (ridge ? 4 : 0));
        find_features(mesh, {}, options);
        EXPECT_EQ(constrained_edges(mesh), 16);  // what was found before is forgotten
    }
}

TEST(FeatureLines, NoFoldTurnsByMoreThan180Degrees) {
    Options options;
    options.feature_angle = 180.0;
    for (int i = 0; i < 100; ++i) {  // rounding takes the product of some of the normals below -1
        const Eigen::AngleAxisd turn(0.1 * i, Point(1.0, 0.3 * i, 2.0).normalized());
        shapes::Shape fold;
        for (const Point& p : {Point(0.0, 0.0, 0.0), Point(1.0, 0.0, 0.0), Point(0.3, 1.0, 0.0), Point(0.6, 0.7, 0.0)}) {
            fold.points.push_back(turn * p);
        }
        fold.triangles = {{0, 1, 2}, {1, 0, 3}};
        SurfaceMesh mesh = fold.mesh();
        find_features(mesh, {}, options);
        EXPECT_EQ(constrained_edges(mesh), 4) << "turn " << i;
    }
}

TEST(FeatureLines, UserEdgesEndAtCorners) {
    SurfaceMesh mesh = shapes::grid(5, 5).mesh();
    Options options;
    options.feature_edges = {{13, 14}, {15, 14}};
    const auto lines = find_features(mesh, {}, options);
    expect_consistent(mesh, lines);
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(mesh.info(Vertex(13)).kind, NodeKind::corner);
    EXPECT_EQ(mesh.info(Vertex(14)).kind, NodeKind::line);
    EXPECT_EQ(mesh.info(Vertex(15)).kind, NodeKind::corner);
}

TEST(FeatureLines, ASourceRunsInItsDirectionAndEndsAtCorners) {
    SurfaceMesh mesh = shapes::grid(5, 4).mesh();  // point (i, j) is 6·j + i
    const std::vector<Source> sources{source({17, 16, 15, 14, 13, 12})};
    const auto lines = find_features(mesh, sources, {});
    expect_consistent(mesh, lines);
    ASSERT_TRUE(lines[0].is_source);
    EXPECT_EQ(lines[0].source, 0);
    ASSERT_EQ(lines[0].nodes.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(lines[0].nodes[i].index(), sources[0].vertices[i]);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const FeatureLine& line) { return line.is_source; }), 1);
    EXPECT_EQ(lines.size(), 7u);  // the source, and the sides, two of which it cuts
    EXPECT_EQ(corners(mesh), 6);
}

TEST(FeatureLines, ASourceIsCutWhereItTurnsSharply) {
    SurfaceMesh mesh = shapes::grid(4, 4).mesh();
    const std::vector<Source> sources{source({6, 7, 8, 13, 18, 17, 16, 11, 6}), source({2, 7})};
    SurfaceMesh ring = mesh;
    const auto lines = find_features(ring, std::span(sources).first(1), {});
    expect_consistent(ring, lines);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const FeatureLine& line) { return line.is_source; }), 4);
    EXPECT_EQ(ring.info(Vertex(6)).kind, NodeKind::corner);
    EXPECT_EQ(ring.info(Vertex(7)).kind, NodeKind::line);
}

TEST(FeatureLines, ASmoothClosedSourceStartsWhereTheUserBegan) {
    SurfaceMesh mesh = shapes::cylinder(16, 4).mesh();
    std::vector<std::int32_t> ring;
    for (int i = 0; i <= 16; ++i) ring.push_back(32 + (i + 5) % 16);
    const std::vector<Source> sources{source(ring)};
    const auto lines = find_features(mesh, sources, {});
    expect_consistent(mesh, lines);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_TRUE(lines[0].is_source && lines[0].closed);
    EXPECT_EQ(lines[0].nodes.front(), Vertex(37));
    EXPECT_EQ(corners(mesh), 0);
}

TEST(FeatureLines, ASourceOnTheBoundaryIsBoth) {
    SurfaceMesh mesh = shapes::grid(4, 4).mesh();
    const std::vector<Source> sources{source({0, 1, 2, 7, 12})};  // leaves the boundary at 2
    const auto lines = find_features(mesh, sources, {});
    expect_consistent(mesh, lines);
    EXPECT_TRUE(lines[0].is_source && lines[0].is_boundary);
    EXPECT_TRUE(lines[1].is_source && !lines[1].is_boundary);
    EXPECT_EQ(mesh.info(Vertex(2)).kind, NodeKind::corner);
    EXPECT_EQ(mesh.info(Vertex(12)).kind, NodeKind::corner);
}

TEST(FeatureLines, DoNotDependOnSizeAndPosition) {
    const shapes::Shape cube = shapes::cube(3);
    SurfaceMesh mesh = cube.mesh();
    const auto lines = find_features(mesh, {}, {});
    for (const double scale : {1e-7, 1e7}) {
        SurfaceMesh other = shapes::placed(cube, scale, {1e3 * scale, 0, -1e3 * scale}).mesh();
        const auto others = find_features(other, {}, {});
        ASSERT_EQ(others.size(), lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(others[i].nodes, lines[i].nodes);
    }
}

}  // namespace
}  // namespace anisoquad
