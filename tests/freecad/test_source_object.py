"""Sources in a document: picked ids, edges of a Part object, triangles of a shape."""

import os
import tempfile
import unittest

import FreeCAD
import Part
from documents import DocumentTest, square

import anisoquad
from anisoquad.objects.quad_mesh_object import result_of

LOWER_EDGE = [0, 1, 2, 3, 4, 5, 6]


class SourceObject(DocumentTest):
    def test_it_measures_its_line(self):
        source = anisoquad.make_source(self.doc, self.base, LOWER_EDGE, anisotropy=4, sides="left")
        self.doc.recompute()
        self.assertEqual((source.Length.Value, source.EdgeCount, source.Sides), (6.0, 6, "left"))
        self.assertEqual([tuple(point) for point in source.Points], [(float(x), 0.0, 0.0) for x in range(7)])
        self.assertEqual(source.SchemaVersion, 1)

    def test_it_follows_the_placement_of_the_base(self):
        self.base.Placement.Base = FreeCAD.Vector(0, 0, 5)
        source = anisoquad.make_source(self.doc, self.base, LOWER_EDGE)
        self.doc.recompute()
        self.assertEqual({point.z for point in source.Points}, {5.0})

    def test_ids_that_the_mesh_does_not_have(self):
        source = anisoquad.make_source(self.doc, self.base, [0, 999])
        self.doc.recompute()
        self.assertIn("Invalid", source.State)
        self.assertIn("999", source.getStatusString())

    def test_the_quad_mesh_follows_its_sources(self):
        source = anisoquad.make_source(self.doc, self.base, LOWER_EDGE, passes="2:1")
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[source])
        self.doc.recompute()
        self.assertIn("1:2", quads.RowsPerPass[0])
        source.Passes = "3:1"
        self.doc.recompute()
        self.assertIn("1:3", quads.RowsPerPass[0])

    def test_its_nodes_are_a_group(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[LOWER_EDGE], passes=[(2, 1)])
        self.doc.recompute()
        mesh = quads.FemMesh
        groups = {mesh.getGroupName(group): mesh.getGroupElements(group) for group in mesh.Groups}
        on_edge = {node for node, point in mesh.Nodes.items() if point.y == 0.0}
        self.assertEqual(set(groups["Source_1"]), on_edge)

    def test_what_can_not_be_read_makes_no_object(self):
        for keywords in ({"passes": "x"}, {"vertices": ["a"]}, {"passes": [2], "anisotropy": 2}, {"sides": "upper"}):
            with self.subTest(keywords), self.assertRaises(anisoquad.MeshError):
                anisoquad.make_source(self.doc, self.base, **keywords)
        self.assertEqual(len(self.doc.Objects), 1)

    def test_a_zigzag_is_imprinted_when_asked_for(self):
        staircase = [15, 16, 24, 25, 33]  # along cells and diagonals in turn
        source = anisoquad.make_source(self.doc, self.base, staircase)
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[source])
        self.doc.recompute()
        self.assertTrue(self.nodes_on_line(quads) - {15, 33}, "the staircase's nodes are kept")
        source.Imprint = True
        self.doc.recompute()
        self.assertEqual(quads.getStatusString(), "Valid")
        self.assertFalse(self.nodes_on_line(quads) & {16, 25}, "its line is straight")
        mesh = quads.FemMesh
        group = next(group for group in mesh.Groups if mesh.getGroupName(group) == "Source_1")
        nodes = [mesh.Nodes[node] for node in mesh.getGroupElements(group)]
        self.assertGreater(len(nodes), 2)
        start, end = FreeCAD.Vector(1, 2, 0), FreeCAD.Vector(5, 4, 0)
        for node in nodes:
            self.assertLess(node.distanceToLine(start, end - start), 1e-6)

    @staticmethod
    def nodes_on_line(quads):
        mesh = result_of(quads)
        return set(mesh.node_input[mesh.node_line >= 0].tolist())


class SecondOrder(DocumentTest):
    def test_quads_of_eight_nodes(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, element_order=2)
        self.doc.recompute()
        mesh = quads.FemMesh
        self.assertEqual(mesh.QuadrangleCount, quads.Quads)
        place = mesh.Nodes
        for face in mesh.Faces:
            nodes = mesh.getElementNodes(face)
            self.assertEqual(len(nodes), 8)
            for k in range(4):
                middle = (place[nodes[k]] + place[nodes[(k + 1) % 4]]) * 0.5
                self.assertLess(middle.distanceToPoint(place[nodes[4 + k]]), 1e-9, "the square is flat")
        groups = {mesh.getGroupName(group): mesh.getGroupElements(group) for group in mesh.Groups}
        lines = {node for name, nodes in groups.items() if name.startswith("Line") for node in nodes}
        on_boundary = {node for node, point in place.items() if 0.0 in (point.x, point.y) or 6.0 in (point.x, point.y)}
        self.assertEqual(lines, on_boundary)

    def test_it_is_exported_in_second_order_also_after_reopening(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, element_order=2)
        with self.assertRaises(anisoquad.MeshError):
            anisoquad.export_quad_mesh(quads, "empty.inp")
        self.doc.recompute()
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("fresh.inp", "stored.inp")]
            anisoquad.export_quad_mesh(quads, paths[0])
            quads.Proxy._restart()
            anisoquad.export_quad_mesh(quads, paths[1])
            first, second = (open(path, encoding="ascii").read() for path in paths)
        self.assertIn("TYPE=S8", first)
        self.assertEqual(first, second)

    def test_the_corners_come_back_from_the_document(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, element_order=2)
        self.doc.recompute()
        fresh = result_of(quads)
        quads.Proxy._restart()
        stored = result_of(quads)
        self.assertTrue((fresh.points == stored.points).all() and (fresh.quads == stored.quads).all())
        self.assertEqual(fresh.report, stored.report)


class PartShape(DocumentTest):
    def setUp(self):
        super().setUp()
        self.tube = self.doc.addObject("Part::Cylinder", "Tube")
        self.triangles = anisoquad.make_triangles(self.doc, self.tube)
        self.doc.recompute()

    def test_the_triangles_follow_the_shape(self):
        height = self.triangles.Mesh.BoundBox.ZLength
        self.tube.Height = 30
        self.doc.recompute()
        self.assertNotEqual(height, self.triangles.Mesh.BoundBox.ZLength)
        self.assertTrue(self.triangles.Mesh.isSolid())

    def test_a_largest_edge_gives_well_shaped_triangles(self):
        self.triangles.MaxLength = 1.0
        self.doc.recompute()
        points, facets = self.triangles.Mesh.Topology
        edges = [points[a].distanceToPoint(points[b]) for f in facets for a, b in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))]
        self.assertLess(max(edges), 2.5)
        self.assertTrue(self.triangles.Mesh.isSolid())

    def test_edges_of_the_shape_are_a_source(self):
        name = next(f"Edge{index + 1}" for index, edge in enumerate(self.tube.Shape.Edges) if isinstance(edge.Curve, Part.Circle))
        source = anisoquad.make_source(self.doc, self.triangles, edges=(self.tube, [name]), anisotropy=2)
        self.doc.recompute()
        self.assertEqual(source.getStatusString(), "Valid")
        self.assertEqual(source.Vertices[0], source.Vertices[-1], "a circle is closed")
        circle = self.tube.Shape.getElement(name).Curve
        self.assertTrue(all(abs(point.distanceToPoint(circle.Center) - circle.Radius) < 1e-6 for point in source.Points))
        self.assertGreater(source.EdgeCount, 8)

    def test_two_edges_that_meet_are_one_line(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        triangles = anisoquad.make_triangles(self.doc, box)
        corner = box.Shape.Vertexes[0].Point
        names = [f"Edge{i + 1}" for i, edge in enumerate(box.Shape.Edges) if any(v.Point == corner for v in edge.Vertexes)][:2]
        source = anisoquad.make_source(self.doc, triangles, edges=(box, names))
        self.doc.recompute()
        self.assertEqual(source.getStatusString(), "Valid")
        self.assertAlmostEqual(source.Length.Value, 20.0)

    def test_edges_that_do_not_meet_are_refused(self):
        circles = [f"Edge{i + 1}" for i, edge in enumerate(self.tube.Shape.Edges) if isinstance(edge.Curve, Part.Circle)]
        source = anisoquad.make_source(self.doc, self.triangles, edges=(self.tube, circles))
        self.doc.recompute()
        self.assertIn("not one line", source.getStatusString())


class Undo(DocumentTest):
    def test_undo_and_redo_bring_the_quads_too(self):
        self.doc.UndoMode = 1
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[LOWER_EDGE], passes=[(2, 1)])
        self.doc.recompute()
        first = quads.FemMesh.QuadrangleCount
        self.doc.openTransaction("coarser")
        self.base.Mesh = square(10)
        self.doc.recompute()
        self.doc.commitTransaction()
        second = quads.FemMesh.QuadrangleCount
        self.assertNotEqual(first, second)
        self.doc.undo()
        self.assertEqual((quads.FemMesh.QuadrangleCount, quads.Quads), (first, first))
        self.doc.redo()
        self.assertEqual((quads.FemMesh.QuadrangleCount, quads.Quads), (second, second))


if __name__ == "__main__":
    unittest.main()
