#include "qmorph/qmorph.h"

#include <gtest/gtest.h>

#include "features/parity.h"
#include "mesh/arrays.h"
#include "mesh/euler_operators.h"
#include "qmorph/node_size.h"
#include "stages.h"

namespace anisoquad {
namespace {

using namespace stages;

QMorphResult fill(Prepared& p) {
    EXPECT_TRUE(make_parity_even(p.mesh).left.empty());
    assign_node_sizes(p.mesh);
    return fill_with_quads(p.mesh, &p.reference);
}

double doubled_volume(const SurfaceMesh& mesh) {
    double sum = 0.0;
    for (const Face f : faces(mesh)) sum += doubled_area(mesh, f).dot(centre(mesh, f)) / 3.0;
    return sum;
}

/// All quads, sound, oriented as the input, with about half as many elements.
void expect_filled(Prepared& p) {
    const double volume = doubled_volume(p.mesh);
    const QMorphResult result = fill(p);
    EXPECT_EQ(result.left, 0);
    EXPECT_EQ(triangle_count(p.mesh), 0);
    expect_sound(p);
    EXPECT_NEAR(signed_area(p), input_area(p.shape), 0.04 * input_area(p.shape));
    EXPECT_NEAR(doubled_volume(p.mesh), volume, 0.06 * std::abs(volume) + 1e-9 * input_area(p.shape));
    const double share = double(p.mesh.face_count()) / double(p.shape.triangles.size());
    EXPECT_GT(share, 0.3);
    EXPECT_LT(share, 0.8);
    for (const Face f : faces(p.mesh)) EXPECT_GE(p.mesh.info(f).patch, 0);
    EXPECT_LE(result.failed_edges, p.mesh.face_count() / 10);
}

TEST(QMorph, FillsAPlane) {
    for (const auto& shape : {shapes::grid(10, 8), shapes::grid(3, 3), shapes::grid(1, 1), shapes::grid(24, 16, 0.5, 0.8)}) {
        Prepared p(shape);
        expect_filled(p);
        EXPECT_NEAR(signed_area(p), input_area(shape), 1e-9 * input_area(shape));
    }
}

TEST(QMorph, FillsAPlaneWithHoles) {
    Prepared p(shapes::grid_with_holes(
        20, 16, [](int i, int j) { return !((i >= 4 && i < 8 && j >= 5 && j < 9) || (i >= 12 && i < 17 && j >= 8 && j < 10)); }));
    ASSERT_EQ(p.before.boundary_loops, 3);
    expect_filled(p);
    EXPECT_NEAR(signed_area(p), input_area(p.shape), 1e-9 * input_area(p.shape));
}

TEST(QMorph, FillsClosedAndOpenCurvedSurfaces) {
    for (const auto& shape : {shapes::cylinder(32, 16), shapes::sphere(32, 20), shapes::torus(48, 20), shapes::cube(6)}) {
        Prepared p(shape);
        expect_filled(p);
    }
}

TEST(QMorph, FillsSeveralComponents) {
    Prepared p(shapes::joined(shapes::sphere(24, 16), shapes::placed(shapes::grid(9, 7), 0.3, Point(4, 0, 0))));
    expect_filled(p);
}

TEST(QMorph, WaitsNearCuts) {
    Prepared p(shapes::grid(40, 10));
    assign_node_sizes(p.mesh);
    Cuts cuts;
    cuts.add(0, 40.0, {Point(0.0, 0.0, 0.0), Point(80.0, 10.0, 0.0)});
    EXPECT_EQ(fill_with_quads(p.mesh, &p.reference, no_context(), cuts).left, 0);  // what waits is not left over
    int quads = 0;
    for (const Face f : faces(p.mesh)) {
        Point middle = Point::Zero();
        for (const HalfEdge h : p.mesh.halfedges(f)) middle += p.mesh.position(p.mesh.from(h)) / p.mesh.valence(f);
        if (middle.x() > 36.0) {
            EXPECT_TRUE(p.mesh.is_triangle(f));
        } else if (middle.x() < 30.0) {
            EXPECT_TRUE(p.mesh.is_quad(f));
        }
        quads += p.mesh.is_quad(f);
    }
    EXPECT_GT(quads, 300);
    expect_filled(p);  // and is filled without them
}

TEST(QMorph, AnOddPatchIsMadeEvenFirst) {
    shapes::Shape shape = shapes::grid(9, 7);
    shape.triangles.erase(shape.triangles.begin());
    Prepared p(shape);
    expect_filled(p);
    Prepared odd(shape);
    assign_node_sizes(odd.mesh);
    EXPECT_EQ(fill_with_quads(odd.mesh).left % 2, 1);  // without that one triangle is left over
    expect_sound(odd);
}

TEST(QMorph, LinesInsideAreCoveredByQuadEdges) {
    const auto middle = path(6 * 15 + 0, 6 * 15 + 14, 1);
    const auto inside = path(9 * 15 + 4, 9 * 15 + 10, 1);
    Prepared p(shapes::grid(14, 12), {source(middle), source(inside)});
    expect_filled(p);
    expect_covered(p.mesh, middle);
    expect_covered(p.mesh, inside);
}

TEST(QMorph, NodesOnLinesDoNotMove) {
    Prepared p(shapes::cube(5));
    expect_filled(p);
    for (const Vertex v : vertices(p.mesh)) {
        if (p.mesh.info(v).kind == NodeKind::interior) continue;
        ASSERT_GE(p.mesh.info(v).input, 0);
        EXPECT_EQ(p.mesh.position(v), p.shape.points[static_cast<std::size_t>(p.mesh.info(v).input)]);
    }
}

TEST(QMorph, QuadsThatExistStay) {
    Prepared p(shapes::grid(10, 8));
    const Face f = p.mesh.face(p.mesh.find_halfedge(Vertex(60), Vertex(61)));
    for (const HalfEdge h : p.mesh.halfedges(f)) {
        const Eigen::Vector3d d = p.mesh.position(p.mesh.to(h)) - p.mesh.position(p.mesh.from(h));
        if (d.x() == 0.0 || d.y() == 0.0) continue;
        dissolve_edge(p.mesh, SurfaceMesh::edge(h));
        break;
    }
    const Face quad = p.mesh.face(p.mesh.find_halfedge(Vertex(60), Vertex(61)));
    ASSERT_TRUE(p.mesh.is_quad(quad));
    p.mesh.info(quad).row = 1;
    for (const HalfEdge h : p.mesh.halfedges(quad)) p.mesh.info(p.mesh.from(h)).in_row = true;
    expect_filled(p);
    EXPECT_EQ(p.mesh.info(p.mesh.face(p.mesh.find_halfedge(Vertex(60), Vertex(61)))).row, 1);
}

TEST(QMorph, TheSameInputGivesTheSameMesh) {
    for (const auto& shape :
         {shapes::sphere(24, 16), shapes::grid_with_holes(12, 12, [](int i, int j) { return i != 5 || j < 4; })}) {
        Prepared a(shape);
        Prepared b(shape);
        fill(a);
        fill(b);
        EXPECT_EQ(to_arrays(a.mesh).faces, to_arrays(b.mesh).faces);
        EXPECT_EQ(to_arrays(a.mesh).points, to_arrays(b.mesh).points);
    }
}

TEST(QMorph, CanBeCancelled) {
    Prepared p(shapes::grid(70, 70));
    assign_node_sizes(p.mesh);
    Context context([](std::string_view, double) { return false; });
    try {
        fill_with_quads(p.mesh, &p.reference, context);
        FAIL() << "not cancelled";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::cancelled);
    }
}

}  // namespace
}  // namespace anisoquad
