#include "mesh/euler_operators.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/validate.h"
#include "shapes.h"

namespace anisoquad {
namespace {

using M = SurfaceMesh;

std::vector<std::pair<const char*, shapes::Shape>> all_shapes() {
    return {{"grid", shapes::grid(6, 5)},
            {"holes", shapes::grid_with_holes(7, 7, [](int i, int j) { return (i != 1 && i != 5) || j != 3; })},
            {"cylinder", shapes::cylinder(7, 3)},
            {"sphere", shapes::sphere(7, 5)},
            {"torus", shapes::torus(6, 5)},
            {"cube", shapes::cube(2)},
            {"two", shapes::joined(shapes::cube(2), shapes::grid(4, 3))}};
}

std::string defects(const SurfaceMesh& mesh) {
    std::string text;
    for (const std::string& defect : validate(mesh)) text += defect + "; ";
    return text;
}

/// Applies random operators, each where it is allowed.
class RandomOperators {
  public:
    RandomOperators(SurfaceMesh& mesh, unsigned seed) : mesh_(mesh), random_(seed) {}

    const char* step() {
        switch (random_() % 7) {
            case 0: return flip_any();
            case 1: return split_any_edge();
            case 2: return split_any_face();
            case 3: return pair_triangles();
            case 4: return cut_quad();
            default: return collapse_any();
        }
    }

  private:
    template <class Handle>
    Handle pick(std::int32_t slots) {
        for (;;) {
            const Handle handle(static_cast<std::int32_t>(random_() % static_cast<unsigned>(slots)));
            if (!mesh_.is_deleted(handle)) return handle;
        }
    }
    Edge edge() { return pick<Edge>(mesh_.edge_slots()); }
    Face face() { return pick<Face>(mesh_.face_slots()); }
    HalfEdge halfedge() { return pick<HalfEdge>(mesh_.halfedge_slots()); }
    bool is_side_triangle(HalfEdge h) const { return mesh_.is_boundary(h) || mesh_.is_triangle(mesh_.face(h)); }
    Point middle(Edge e) const {
        return 0.5 * (mesh_.position(mesh_.from(M::halfedge(e))) + mesh_.position(mesh_.to(M::halfedge(e))));
    }

    const char* flip_any() {
        const Edge e = edge();
        if (!is_flip_ok(mesh_, e)) return "";
        flip(mesh_, e);
        return "flip";
    }
    const char* split_any_edge() {
        const Edge e = edge();
        if (!is_side_triangle(M::halfedge(e, 0)) || !is_side_triangle(M::halfedge(e, 1))) return "";
        const HalfEdge h = M::halfedge(e);
        const Vertex v = split_edge(mesh_, e, middle(e));
        EXPECT_EQ(mesh_.to(h), v);
        return "split_edge";
    }
    const char* split_any_face() {
        const Face f = face();
        const Point p = mesh_.position(mesh_.from(mesh_.halfedge(f)));
        const int n = mesh_.valence(f);
        EXPECT_EQ(mesh_.valence(split_face(mesh_, f, p)), n);
        return "split_face";
    }
    const char* pair_triangles() {
        const Edge e = edge();
        if (!is_flip_ok(mesh_, e)) return "";
        EXPECT_TRUE(mesh_.is_quad(dissolve_edge(mesh_, e)));
        return "dissolve_edge";
    }
    const char* cut_quad() {
        const Face f = face();
        if (!mesh_.is_quad(f)) return "";
        const HalfEdge h = mesh_.halfedge(f);
        const HalfEdge g = mesh_.next(mesh_.next(h));
        if (mesh_.find_halfedge(mesh_.from(h), mesh_.from(g)).is_valid()) return "";
        const HalfEdge d = insert_edge(mesh_, h, g);
        EXPECT_EQ(mesh_.from(d), mesh_.from(h));
        EXPECT_EQ(mesh_.to(d), mesh_.from(g));
        return "insert_edge";
    }
    const char* collapse_any() {
        const HalfEdge h = halfedge();
        if (!is_collapse_ok(mesh_, h)) return "";
        const Vertex kept = mesh_.to(h);
        collapse(mesh_, h);
        EXPECT_FALSE(mesh_.is_deleted(kept));
        return "collapse";
    }

    SurfaceMesh& mesh_;
    std::mt19937 random_;
};

TEST(EulerOperators, RandomSequencesKeepTheMeshValid) {
    for (const auto& [name, shape] : all_shapes()) {
        for (unsigned seed = 0; seed < 20; ++seed) {
            SurfaceMesh mesh = shape.mesh();
            const Topology before = topology(mesh);
            RandomOperators random(mesh, seed);
            std::string last;
            for (int i = 0; i < 400; ++i) {
                last = random.step();
                ASSERT_EQ(defects(mesh), "") << name << ", seed " << seed << ", step " << i << ": " << last;
                ASSERT_TRUE(topology(mesh) == before) << name << ", seed " << seed << ", step " << i << ": " << last;
            }
        }
    }
}

TEST(EulerOperators, ATetrahedronCannotBeCollapsed) {
    shapes::Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    shape.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const SurfaceMesh mesh = shape.mesh();
    for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) EXPECT_FALSE(is_collapse_ok(mesh, HalfEdge(i)));
}

TEST(EulerOperators, CollapsingUntilNothingIsLeftToCollapseKeepsTheTopology) {
    for (const auto& [name, shape] : all_shapes()) {
        SurfaceMesh mesh = shape.mesh();
        const Topology before = topology(mesh);
        for (bool any = true; any;) {
            any = false;
            for (std::int32_t i = 0; i < mesh.halfedge_slots(); ++i) {
                if (mesh.is_deleted(HalfEdge(i)) || !is_collapse_ok(mesh, HalfEdge(i))) continue;
                collapse(mesh, HalfEdge(i));
                any = true;
                ASSERT_EQ(defects(mesh), "") << name;
            }
        }
        EXPECT_TRUE(topology(mesh) == before) << name;
    }
}

TEST(EulerOperators, FlipTwiceGivesTheSameEdges) {
    SurfaceMesh mesh = shapes::grid(4, 4).mesh();
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        const Edge e(i);
        if (!is_flip_ok(mesh, e)) continue;
        const Vertex a = mesh.from(M::halfedge(e));
        const Vertex b = mesh.to(M::halfedge(e));
        flip(mesh, e);
        EXPECT_FALSE(mesh.find_halfedge(a, b).is_valid());
        ASSERT_TRUE(is_flip_ok(mesh, e));
        flip(mesh, e);
        EXPECT_TRUE(mesh.find_halfedge(a, b).is_valid());
    }
    EXPECT_EQ(defects(mesh), "");
}

TEST(EulerOperators, ConstrainedEdgesAreNotFlipped) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    for (std::int32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_boundary(Edge(i))) {
            EXPECT_FALSE(is_flip_ok(mesh, Edge(i)));
        }
        mesh.info(Edge(i)).line = 0;
        EXPECT_FALSE(is_flip_ok(mesh, Edge(i)));
    }
}

TEST(EulerOperators, SplitEdgeHandsItsLineDown) {
    SurfaceMesh mesh = shapes::grid(2, 2).mesh();
    const HalfEdge h = mesh.find_halfedge(Vertex(3), Vertex(4));
    mesh.info(M::edge(h)) = {7, true};
    mesh.info(mesh.face(h)).patch = 2;
    const Vertex v = split_edge(mesh, M::edge(h), {0.5, 1.0, 0.0});
    EXPECT_EQ(mesh.info(v).line, 7);
    EXPECT_EQ(mesh.info(v).kind, NodeKind::line);
    EXPECT_EQ(mesh.info(v).input, -1);
    EXPECT_EQ(mesh.valence(v), 4);
    int on_line = 0;
    for (const HalfEdge out : mesh.outgoing(v)) on_line += mesh.info(M::edge(out)).line == 7 && mesh.info(M::edge(out)).source;
    EXPECT_EQ(on_line, 2);
    int in_patch = 0;
    for (const HalfEdge out : mesh.outgoing(v)) in_patch += mesh.info(mesh.face(out)).patch == 2;
    EXPECT_EQ(in_patch, 2);
}

TEST(EulerOperators, InsertVertexAndDissolveVertexCancel) {
    for (const auto& [name, shape] : all_shapes()) {
        SurfaceMesh mesh = shape.mesh();
        const std::int32_t edges = mesh.edge_slots();
        for (std::int32_t i = 0; i < edges; ++i) {
            const HalfEdge h = M::halfedge(Edge(i));
            const Vertex a = mesh.from(h);
            const Vertex b = mesh.to(h);
            insert_vertex(mesh, Edge(i), mesh.position(a));
            EXPECT_EQ(dissolve_vertex(mesh, h), h);
            EXPECT_EQ(mesh.from(h), a);
            EXPECT_EQ(mesh.to(h), b);
        }
        EXPECT_EQ(defects(mesh), "") << name;
        EXPECT_EQ(mesh.edge_count(), edges);
    }
}

TEST(EulerOperators, CollapseKeepsTheFeatureLine) {
    SurfaceMesh mesh = shapes::grid(3, 2).mesh();  // the line y = 1 runs over 4, 5, 6, 7
    for (const std::int32_t a : {4, 5, 6}) mesh.info(M::edge(mesh.find_halfedge(Vertex(a), Vertex(a + 1)))).line = 3;
    const HalfEdge h = mesh.find_halfedge(Vertex(5), Vertex(6));
    ASSERT_TRUE(is_collapse_ok(mesh, h));
    collapse(mesh, h);
    EXPECT_EQ(defects(mesh), "");
    for (const std::int32_t a : {4, 7}) {
        const HalfEdge k = mesh.find_halfedge(Vertex(a), Vertex(6));
        ASSERT_TRUE(k.is_valid());
        EXPECT_EQ(mesh.info(M::edge(k)).line, 3);
    }
}

/// The closed loop of half-edges through the nodes.
std::vector<HalfEdge> loop_of(const SurfaceMesh& mesh, const std::vector<std::int32_t>& nodes) {
    std::vector<HalfEdge> loop;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        loop.push_back(mesh.find_halfedge(Vertex(nodes[i]), Vertex(nodes[(i + 1) % nodes.size()])));
    return loop;
}

TEST(ReplaceRegion, MakesOneFaceOfADisk) {
    SurfaceMesh mesh = shapes::grid(5, 5).mesh();  // point (i, j) is 6·j + i
    const Topology before = topology(mesh);
    const auto loop = loop_of(mesh, {7, 8, 9, 15, 21, 20, 19, 13});  // around (2, 2)
    std::vector<Face> faces;
    ASSERT_TRUE(collect_region(mesh, loop, faces));
    EXPECT_EQ(faces.size(), 8u);
    const Face f = replace_region(mesh, loop, faces);
    EXPECT_EQ(mesh.valence(f), 8);
    EXPECT_TRUE(mesh.is_deleted(Vertex(14)));
    EXPECT_TRUE(topology(mesh) == before);
    const HalfEdge d = insert_edge(mesh, loop[0], loop[3]);  // two faces of four and six edges
    EXPECT_TRUE(mesh.is_quad(mesh.face(SurfaceMesh::twin(d))) || mesh.is_quad(mesh.face(d)));
    EXPECT_TRUE(topology(mesh) == before);
}

TEST(ReplaceRegion, WorksAtTheBoundary) {
    SurfaceMesh mesh = shapes::grid(3, 3).mesh();
    const Topology before = topology(mesh);
    const auto loop = loop_of(mesh, {0, 1, 5, 4});
    std::vector<Face> faces;
    ASSERT_TRUE(collect_region(mesh, loop, faces));
    replace_region(mesh, loop, faces);
    EXPECT_EQ(defects(mesh), "");
    EXPECT_TRUE(topology(mesh) == before);
}

TEST(ReplaceRegion, RefusesWhatIsNoDiskOrHoldsALine) {
    std::vector<Face> faces;
    {
        const SurfaceMesh mesh = shapes::grid(5, 5).mesh();
        std::vector<HalfEdge> outwards;
        for (const HalfEdge h : loop_of(mesh, {14, 20, 21, 15})) outwards.push_back(h);  // clockwise: all the rest is on the left
        EXPECT_FALSE(collect_region(mesh, outwards, faces));
    }
    {
        SurfaceMesh mesh = shapes::grid(5, 5).mesh();
        mesh.info(M::edge(mesh.find_halfedge(Vertex(13), Vertex(14)))).line = 0;
        EXPECT_FALSE(collect_region(mesh, loop_of(mesh, {7, 8, 9, 15, 21, 20, 19, 13}), faces));
    }
    {
        const SurfaceMesh mesh = shapes::cylinder(6, 4).mesh();
        EXPECT_FALSE(collect_region(mesh, loop_of(mesh, {6, 7, 8, 9, 10, 11}), faces));  // around the band
    }
    {
        const SurfaceMesh mesh = shapes::grid(30, 30).mesh();
        EXPECT_FALSE(collect_region(mesh, loop_of(mesh, {32, 33, 64, 63}), faces, 1));
        EXPECT_TRUE(collect_region(mesh, loop_of(mesh, {32, 33, 64, 63}), faces, 2));
    }
}

}  // namespace
}  // namespace anisoquad
