"""From a Part object in one step: nodes on the shape, sources by edges, groups, recompute, errors."""

import json
import unittest

import FreeCAD
import numpy as np
import Part
from part_case import PartTest
from shapes import largest_distance, leading_edge, loft_wing

import anisoquad
from anisoquad.cad import CadShape
from anisoquad.convert import fem_mesh_to_arrays
from anisoquad.objects.base_mesh import base_arrays
from anisoquad.objects.shape_link import shape_of
from anisoquad.objects.triangles_object import tessellation_of


def groups_of(fem_mesh):
    return {fem_mesh.getGroupName(group): fem_mesh.getGroupElements(group) for group in fem_mesh.Groups}


class Wing(PartTest):
    def setUp(self):
        super().setUp()
        self.wing = loft_wing(self.doc)
        self.edge = leading_edge(self.wing)

    def make(self, **keywords):
        keywords = {"sources": [(self.wing, self.edge)], "anisotropy": 16, "options": anisoquad.Options(size=50.0), **keywords}
        quads = anisoquad.make_quad_mesh(self.doc, base=self.wing, **keywords)
        self.doc.recompute()
        return quads

    def assert_rows(self, quads):
        """Passes of 1:16 were run, and the first one built rows on both sides of the edge."""
        passes = json.loads(quads.Report)["passes"]
        self.assertEqual({entry["pass"] for entry in passes}, {1, 2, 3})
        first = {entry["side"]: entry["rows"] for entry in passes if entry["pass"] == 1}
        self.assertEqual(set(first), {"left", "right"})
        self.assertGreaterEqual(min(first.values()), 1, passes)

    def test_the_leading_edge_gets_rows_and_all_nodes_lie_on_the_shape(self):
        quads = self.make()
        self.assert_good(quads, self.wing.Shape)
        self.assert_rows(quads)
        self.assertIs(quads.Part, self.wing)

    def test_the_mesh_follows_the_span_with_the_same_sources(self):
        quads = self.make()
        before = quads.FemMesh.BoundBox.YMax
        self.doc.WingTip.Placement.Base.y = 1300.0
        self.doc.WingTip.Placement.Base.x = 0.25 * 500.0 + 0.2 * 1300.0
        self.doc.recompute()
        self.assert_good(quads, self.wing.Shape)
        self.assert_rows(quads)
        self.assertAlmostEqual(quads.FemMesh.BoundBox.YMax, before + 300.0, places=6)
        self.assertEqual(quads.Sources[0].Edges, (self.wing, [self.edge]))
        self.assertAlmostEqual(quads.Sources[0].Length.Value, self.wing.Shape.getElement(self.edge).Length, places=3)

    def test_rows_come_at_every_size(self):
        quads = self.make(options=anisoquad.Options(size=15.0))
        for size in (15.0, 20.0, 30.0, 45.0):
            with self.subTest(size=size):
                quads.Size = size
                self.doc.recompute()
                self.assert_good(quads, self.wing.Shape)
                self.assert_rows(quads)

    def test_patches_and_groups_are_those_of_the_faces_and_edges(self):
        quads = self.make()
        groups, fem_mesh = groups_of(quads.FemMesh), quads.FemMesh
        self.assertEqual(json.loads(quads.Report)["patches"], len(self.wing.Shape.Faces))
        faces = [groups[f"Face{i + 1}"] for i in range(len(self.wing.Shape.Faces))]
        self.assertEqual(sorted(sum(map(list, faces), [])), sorted(fem_mesh.Faces))
        for index, face in enumerate(self.wing.Shape.Faces):
            nodes = {node for element in faces[index] for node in fem_mesh.getElementNodes(element)}
            self.assertLess(max(face.distToShape(Part.Vertex(*fem_mesh.Nodes[node]))[0] for node in nodes), 1e-4)
        for index, edge in enumerate(self.wing.Shape.Edges):
            nodes = groups[f"Edge{index + 1}"]
            self.assertGreaterEqual(len(nodes), 2)
            self.assertLess(max(edge.distToShape(Part.Vertex(*fem_mesh.Nodes[node]))[0] for node in nodes), 1e-4)
        self.assertEqual(set(groups["Source_1"]), set(groups[self.edge]))

    def test_sources_in_every_notation(self):
        for source in (self.edge, [self.edge], (self.wing, self.edge), ("Wing", self.edge), (self.wing, [self.edge])):
            with self.subTest(source):
                quads = anisoquad.make_quad_mesh(self.doc, base=self.wing, sources=[source])
                self.assertEqual(quads.Sources[0].Edges, (self.wing, [self.edge]))
        self.assertEqual(len({quads.Base for quads in self.doc.Objects if hasattr(quads, "QuadData")}), 1, "one triangulation for all")

    def test_smooth_faces_can_be_one_patch(self):
        separate = json.loads(self.make().Report)["patches"]
        joined = self.make(sources=[], smooth_angle=60.0)
        self.assertEqual(joined.getStatusString(), "Valid")
        self.assertLess(json.loads(joined.Report)["patches"], separate)
        self.assertLess(largest_distance(self.wing.Shape, joined.FemMesh), 1e-7 * self.wing.Shape.BoundBox.DiagonalLength)

    def test_second_order_nodes_lie_on_the_shape_too(self):
        quads = self.make(element_order=2)
        self.assertEqual(len(quads.FemMesh.getElementNodes(quads.FemMesh.Faces[0])), 8)
        self.assert_good(quads, self.wing.Shape)

    def test_the_triangles_alone_can_be_meshed(self):
        quads = self.make()
        quads.OntoShape = False
        self.doc.recompute()
        self.assertEqual(quads.getStatusString(), "Valid")
        self.assertIsNone(quads.Part)
        self.assertGreater(largest_distance(self.wing.Shape, quads.FemMesh), 1e-7 * self.wing.Shape.BoundBox.DiagonalLength)
        self.assertNotIn("Face1", groups_of(quads.FemMesh))

    def test_reverse_turns_the_sides_round(self):
        quads = self.make()
        source = quads.Sources[0]
        line = source.Vertices
        source.Reverse = True
        self.doc.recompute()
        self.assertEqual(source.Vertices, line[::-1])


class OwnTriangles(PartTest):
    def test_the_mesh_object_holds_them_as_they_were_made(self):
        wing = loft_wing(self.doc)
        triangles = anisoquad.make_triangles(self.doc, wing)
        self.doc.recompute()
        points, facets = base_arrays(triangles)
        shape = CadShape.from_brep(shape_of(wing).exportBrepToString())
        made_points, made_facets = shape.triangulate(*tessellation_of(triangles))
        self.assertEqual(facets.tolist(), made_facets.tolist())
        self.assertLess(abs(points - made_points).max(), 1e-6 * shape.diagonal)

    def test_faces_that_are_not_sewn_are_one_surface(self):
        loose = self.doc.addObject("Part::Feature", "Loose")
        loose.Shape = Part.makeCompound([face.copy() for face in Part.makeBox(30, 20, 10).Faces])
        quads = anisoquad.make_quad_mesh(self.doc, base=loose, options=anisoquad.Options(size=4.0))
        self.doc.recompute()
        self.assert_good(quads, loose.Shape)
        self.assertEqual(json.loads(quads.Report)["patches"], 6)
        _, ids = fem_mesh_to_arrays(quads.FemMesh)
        sides = np.sort(np.stack([ids, np.roll(ids, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
        self.assertEqual(set(np.unique(sides, axis=0, return_counts=True)[1].tolist()), {2}, "every side has two quads")


class ShellConstraints(PartTest):
    def test_constraints_on_the_shape_find_their_nodes(self):
        """A force on a face and a fixed edge, set on the Part object, through FEM's own objects in CalculiX."""
        import tempfile

        import ObjectsFem
        from femtools.ccxtools import FemToolsCcx

        plate = self.doc.addObject("Part::Cylinder", "Tube")
        plate.Radius, plate.Height, plate.Angle = 50.0, 200.0, 180.0
        shell = self.doc.addObject("Part::Feature", "Shell")
        self.doc.recompute()
        curved = next(face for face in plate.Shape.Faces if isinstance(face.Surface, Part.Cylinder))
        shell.Shape = Part.makeShell([curved])
        quads = anisoquad.make_quad_mesh(self.doc, base=shell, options=anisoquad.Options(size=12.0))
        self.doc.recompute()
        self.assert_good(quads, shell.Shape)
        arc = next(f"Edge{i + 1}" for i, e in enumerate(shell.Shape.Edges) if isinstance(e.Curve, Part.Circle) and e.CenterOfMass.z < 1.0)

        analysis = ObjectsFem.makeAnalysis(self.doc, "Analysis")
        solver = ObjectsFem.makeSolverCalculixCcxTools(self.doc, "Solver")
        material = ObjectsFem.makeMaterialSolid(self.doc, "Material")
        material.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7900 kg/m^3"}
        thickness = ObjectsFem.makeElementGeometry2D(self.doc, 2.0, "Thickness")
        fixed = ObjectsFem.makeConstraintFixed(self.doc, "Fixed")
        fixed.References = [(shell, arc)]
        force = ObjectsFem.makeConstraintForce(self.doc, "Force")
        force.References = [(shell, "Face1")]
        force.Force = 100.0
        force.Direction = (shell, [next(f"Edge{i + 1}" for i, e in enumerate(shell.Shape.Edges) if e.BoundBox.ZLength > 100)])
        for obj in (solver, material, thickness, fixed, force, quads):
            analysis.addObject(obj)
        self.doc.recompute()

        fem_mesh, groups = quads.FemMesh, groups_of(quads.FemMesh)
        self.assertEqual(set(fem_mesh.getNodesByFace(shell.Shape.Faces[0])), set(fem_mesh.Nodes))
        self.assertEqual(set(fem_mesh.getNodesByEdge(shell.Shape.getElement(arc))), set(groups[arc]))
        with tempfile.TemporaryDirectory() as folder:
            tools = FemToolsCcx(analysis, solver)
            tools.setup_working_dir(folder)
            self.assertFalse(tools.update_objects() or tools.check_prerequisites())
            tools.purge_results()
            tools.write_inp_file()
            with open(tools.inp_file_name, encoding="ascii") as file:
                deck = file.read().split("*NSET,NSET=Fixed", 1)[1]
            written = [int(line.strip(" ,\n")) for line in deck.split("**", 1)[0].splitlines() if line.strip(" ,\n").isdecimal()]
            self.assertEqual(set(written), set(groups[arc]))
            tools.setup_ccx()
            self.assertEqual(tools.ccx_run(), 0, tools.ccx_stdout[-300:])
            tools.load_results()
        result = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::FemResultObject"))
        lengths = dict(zip(result.NodeNumbers, result.DisplacementLengths))
        held = max(lengths[node] for node in groups[arc])
        self.assertLess(held, 1e-9)
        self.assertGreater(max(lengths.values()), 1e-5)


class Errors(PartTest):
    def test_a_shape_without_faces(self):
        line = self.doc.addObject("Part::Line", "Line")
        self.doc.recompute()
        quads = anisoquad.make_quad_mesh(self.doc, base=line)
        self.doc.recompute()
        self.assertIn("no faces", quads.Base.getStatusString())

    def test_invalid_faces_are_refused_and_with_repair_meshed_as_they_are(self):
        corner = "\n10 20 30\n"
        text = Part.makeBox(10, 20, 30).exportBrepToString()
        self.assertIn(corner, text)
        broken = self.doc.addObject("Part::Feature", "Broken")
        shape = Part.Shape()
        shape.importBrepFromString(text.replace(corner, "\n10 20 30.001\n"))  # a vertex off its edges
        broken.Shape = shape
        quads = anisoquad.make_quad_mesh(self.doc, base=broken, sources=["Edge1"], anisotropy=2, options=anisoquad.Options(size=3.0))
        self.doc.recompute()
        self.assertIn("invalid faces: Face2, Face4, Face6", quads.getStatusString())
        self.assertEqual(quads.FemMesh.FaceCount, 0)
        quads.Repair = True
        self.doc.recompute()
        self.assertEqual(quads.getStatusString(), "Valid")
        self.assertEqual(quads.FemMesh.FaceCount, quads.FemMesh.QuadrangleCount)
        self.assertGreater(quads.FemMesh.QuadrangleCount, 100)
        self.assertIn("invalid faces of the shape were taken as they are: Face2, Face4, Face6", json.loads(quads.Report)["warnings"])

    def test_a_source_on_an_edge_that_is_not_there(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        quads = anisoquad.make_quad_mesh(self.doc, base=box, sources=["Edge99"])
        self.doc.recompute()
        self.assertIn("Edge99", quads.Sources[0].getStatusString())
        with self.assertRaises(anisoquad.MeshError):
            anisoquad.make_quad_mesh(self.doc, base=box, sources=["Face1"])
        with self.assertRaises(anisoquad.MeshError):
            anisoquad.make_quad_mesh(self.doc, base=self.base, sources=["Edge1"])

    def test_triangles_of_another_shape(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        link = anisoquad.objects.shape_link.link_to(box)
        with self.assertRaises(anisoquad.MeshError) as caught:
            link.surface([[0, 0, 0], [5, 0, 0], [0, 5, 0]], [[0, 1, 2]])
        self.assertEqual(caught.exception.code, "shape_mismatch")
        self.assertIn("Box", str(caught.exception))
        self.assertIn("Edge", str(caught.exception))


class Placement(PartTest):
    def test_a_part_inside_a_moved_container(self):
        container = self.doc.addObject("App::Part", "Container")
        box = self.doc.addObject("Part::Box", "Box")
        container.addObject(box)
        container.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 20, 3), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30))
        box.Placement.Base = FreeCAD.Vector(0, 0, 7)
        quads = anisoquad.make_quad_mesh(self.doc, base=box)
        self.doc.recompute()
        world = box.Shape.copy()
        world.Placement = box.getGlobalPlacement()
        self.assert_good(quads, world)


if __name__ == "__main__":
    unittest.main()
