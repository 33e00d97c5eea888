"""A Part object triangulated by Gmsh: nodes on the shape, no quad inverted, parameters, errors, files."""

import json
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import Part
from part_case import PartTest
from shapes import leading_edge, loft_wing

import anisoquad
from anisoquad.cad import CadShape, CadSurface
from anisoquad.gmsh import has_gmsh, triangulate


class GmshTest(PartTest):
    def cylinder(self):
        tube = self.doc.addObject("Part::Cylinder", "Tube")
        tube.Radius, tube.Height = 10.0, 30.0
        self.doc.recompute()
        return tube


@unittest.skipUnless(has_gmsh(), "Gmsh is not installed")
class ByGmsh(GmshTest):
    def test_a_cylinder_follows_its_size_and_radius(self):
        tube = self.cylinder()
        quads = anisoquad.make_quad_mesh(self.doc, base=tube, triangulator="Gmsh", options=anisoquad.Options(size=3.0))
        self.doc.recompute()
        self.assert_good(quads, tube.Shape)
        triangles = quads.Base
        self.assertEqual((triangles.Triangulator, triangles.Size.Value, triangles.CurvatureAngle.Value), ("Gmsh", 3.0, 30.0))
        before = triangles.Mesh.CountFacets
        triangles.Size = 1.5
        self.doc.recompute()
        self.assertGreater(triangles.Mesh.CountFacets, 2 * before)
        tube.Radius = 12.0
        self.doc.recompute()
        self.assert_good(quads, tube.Shape)
        self.assertGreater(quads.FemMesh.BoundBox.XMax, 11.9)
        triangles.Triangulator = "OpenCASCADE"
        self.doc.recompute()
        self.assert_good(quads, tube.Shape)

    def test_a_wings_leading_edge_gets_its_fineness_and_its_rows(self):
        wing = loft_wing(self.doc)
        quads = anisoquad.make_quad_mesh(self.doc, base=wing, sources=[leading_edge(wing)], anisotropy=16, triangulator="Gmsh",
                                         options=anisoquad.Options(size=40.0))
        self.doc.recompute()
        self.assert_good(quads, wing.Shape)
        self.assertGreater(sum(entry["rows"] for entry in json.loads(quads.Report)["passes"]), 4)
        shortest = min(edge.Length for edge in (self.edge(facet) for facet in quads.Base.Mesh.Facets))
        self.assertLess(shortest, 0.25 * 40.0)

    @staticmethod
    def edge(facet):
        """The shortest edge of a facet."""
        corners = [FreeCAD.Vector(*point) for point in facet.Points]
        return min((a - b for a, b in zip(corners, corners[1:] + corners[:1])), key=lambda edge: edge.Length)

    def test_files_in_other_units(self):
        shape = loft_wing(self.doc).Shape
        self.addCleanup(Part.exportUnits, "MM")
        with tempfile.TemporaryDirectory() as folder:
            for unit, suffix in (("MM", "iges"), ("M", "step"), ("INCH", "igs")):
                with self.subTest(suffix):
                    Part.exportUnits(unit)
                    path = os.path.join(folder, f"wing.{suffix}")
                    (shape.exportStep if suffix == "step" else shape.exportIges)(path)
                    points, triangles = triangulate(path, size=60.0)
                    surface = CadSurface(CadShape.from_file(path), points, triangles)
                    mesh = anisoquad.quad_mesh(points, triangles, surface=surface)
                    self.assertTrue(mesh.valid)
                    self.assertLess(max(shape.distToShape(Part.Vertex(*point))[0] for point in mesh.points[::20]), 1e-4)

    def test_a_moved_part_saved_and_opened(self):
        tube = self.cylinder()
        tube.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 20, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 40))
        quads = anisoquad.make_quad_mesh(self.doc, base=tube, triangulator="Gmsh")
        self.doc.recompute()
        self.assert_good(quads, tube.Shape)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tube.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        quads, tube = self.doc.getObject("QuadMesh"), self.doc.getObject("Tube")
        self.assertEqual(quads.Base.Triangulator, "Gmsh")
        tube.Height = 20.0
        self.doc.recompute()
        self.assert_good(quads, tube.Shape)

    def test_cancel_ends_the_run_and_keeps_the_triangles(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.cylinder(), triangulator="Gmsh")
        self.doc.recompute()
        triangles, before = quads.Base, quads.Base.Mesh.CountFacets
        triangles.Size = 0.02
        job = triangles.Proxy.missing_run(triangles)
        calls = []
        with self.assertRaises(anisoquad.Cancelled):
            job.run(lambda stage, fraction: calls.append(stage) or len(calls) < 3)
        self.assertEqual(len(calls), 3)
        self.assertEqual(triangles.Mesh.CountFacets, before)

    def test_a_run_made_elsewhere_is_taken_over(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.cylinder(), triangulator="Gmsh")
        triangles = quads.Base
        job = triangles.Proxy.missing_run(triangles)
        triangles.Proxy.keep(job, job.run())
        self.assertIsNone(triangles.Proxy.missing_run(triangles))
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            self.doc.recompute()
        self.assertEqual(quads.getStatusString(), "Valid")


class GmshErrors(GmshTest):
    def test_without_the_program_the_status_names_the_package(self):
        quads = anisoquad.make_quad_mesh(self.doc, base=self.cylinder(), triangulator="Gmsh")
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            self.doc.recompute()
        self.assertIn("apt-get install gmsh", quads.Base.getStatusString())
        self.assertEqual(quads.Quads, 0)

    def test_another_triangulator(self):
        tube = self.cylinder()
        objects = len(self.doc.Objects)
        for base, name in ((tube, "Netgen"), (self.base, "Gmsh"), (None, "Gmsh")):
            with self.subTest(name), self.assertRaises(anisoquad.MeshError) as caught:
                anisoquad.make_quad_mesh(self.doc, base=base, triangulator=name)
            self.assertEqual(caught.exception.code, "invalid_option")
        with self.assertRaises(anisoquad.MeshError):
            anisoquad.make_triangles(self.doc, tube, triangulator="gmsh")
        self.assertEqual(len(self.doc.Objects), objects)


if __name__ == "__main__":
    unittest.main()
