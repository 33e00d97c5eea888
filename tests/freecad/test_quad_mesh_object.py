"""The parametric object: fills, recomputes, keeps, tells."""

import json
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
from documents import DocumentTest, square

import anisoquad
from anisoquad import convert
from anisoquad.objects.mesh_job import MeshJob

LOWER_EDGE = [0, 1, 2, 3, 4, 5, 6]


class Object(DocumentTest):
    def make(self, **keywords):
        obj = anisoquad.make_quad_mesh(self.doc, base=self.base, **keywords)
        self.doc.recompute()
        return obj

    def assert_filled(self, obj):
        self.assertEqual(obj.getStatusString(), "Valid")
        self.assertGreater(obj.FemMesh.QuadrangleCount, 0)
        self.assertEqual(obj.FemMesh.QuadrangleCount, obj.FemMesh.FaceCount)
        self.assertEqual(obj.FemMesh.QuadrangleCount, obj.Quads)
        self.assertEqual(obj.FemMesh.NodeCount, obj.Nodes)

    def test_it_is_filled_and_reports(self):
        obj = self.make()
        self.assert_filled(obj)
        self.assertEqual(obj.TrianglesIn, self.base.Mesh.CountFacets)
        self.assertGreater(obj.MinScaledJacobian, 0.0)
        self.assertGreaterEqual(obj.MeanScaledJacobian, obj.MinScaledJacobian)
        self.assertEqual(json.loads(obj.Report)["quads"], obj.Quads)
        for name in ("Quads", "MinScaledJacobian", "Report"):
            self.assertIn("ReadOnly", obj.getEditorMode(name))

    def test_options_have_the_defaults_of_the_core(self):
        obj = self.make()
        self.assertEqual(obj.FeatureAngle, anisoquad.Options().feature_angle)
        self.assertEqual(obj.Cleanup, anisoquad.Options().cleanup)

    def test_options_are_kept_and_used(self):
        options = anisoquad.Options(feature_angle=20.0, feature_edges=[[8, 9], [9, 10]])
        obj = self.make(options=options)
        self.assert_filled(obj)
        self.assertEqual(obj.FeatureAngle, 20.0)
        self.assertEqual(obj.FeatureEdges, [8, 9, 9, 10])

    def test_groups_of_patches_rows_and_lines(self):
        obj = self.make(sources=[LOWER_EDGE], passes=[(2, 1)])
        self.assert_filled(obj)
        mesh = obj.FemMesh
        groups = {mesh.getGroupName(group): group for group in mesh.Groups}
        self.assertIn("Patch_1", groups)
        self.assertIn("Source_1_Pass_1", groups)
        faces = [face for name, group in groups.items() if name.startswith("Patch") for face in mesh.getGroupElements(group)]
        self.assertEqual(sorted(faces), sorted(mesh.Faces))
        lines = [node for name, group in groups.items() if name.startswith("Line") for node in mesh.getGroupElements(group)]
        on_boundary = {node for node, point in mesh.Nodes.items() if 0.0 in (point.x, point.y) or 6.0 in (point.x, point.y)}
        self.assertLessEqual(on_boundary, set(lines))
        self.assertTrue(any("pass 1" in line for line in obj.RowsPerPass))

    def test_it_recomputes_when_a_source_changes(self):
        obj = self.make(sources=[LOWER_EDGE])
        self.assertEqual(list(obj.RowsPerPass), [])
        obj.Sources[0].Passes = "2:1"
        self.doc.recompute()
        self.assert_filled(obj)
        self.assertTrue(obj.RowsPerPass)

    def test_it_recomputes_when_the_base_mesh_changes_and_only_then(self):
        obj = self.make()
        self.assertEqual(self.doc.recompute(), 0)
        quads = obj.Quads
        self.base.Mesh = square(10)
        self.doc.recompute()
        self.assert_filled(obj)
        self.assertGreater(obj.Quads, quads)

    def test_the_base_is_read_once_and_again_after_a_change(self):
        obj = self.make(sources=[LOWER_EDGE])
        with mock.patch.object(convert, "mesh_content", wraps=convert.mesh_content) as read:
            self.base.Mesh = square(10)
            self.doc.recompute()
            self.assertEqual(read.call_count, 1)
            obj.touch()
            obj.Sources[0].touch()
            self.doc.recompute()
            self.assertEqual(read.call_count, 1)

    def test_what_was_prepared_for_the_document_is_taken_once(self):
        obj = self.make(sources=[LOWER_EDGE], element_order=2)
        job = MeshJob.of(obj)
        run = job.run_for_document()
        prepared = run.take_fem_mesh(job)
        again = run.take_fem_mesh(job)
        self.assertIsNot(prepared, again)
        for mesh in (prepared, again, obj.FemMesh):
            self.assertEqual((mesh.NodeCount, mesh.FaceCount, mesh.GroupCount),
                             (obj.FemMesh.NodeCount, obj.Quads, obj.FemMesh.GroupCount))
            self.assertEqual(mesh.getElementNodes(1), obj.FemMesh.getElementNodes(1))
        self.assertEqual(len(prepared.getElementNodes(1)), 8)
        self.assertEqual(run.packed, obj.QuadData)

    def test_it_follows_the_placement_of_the_base(self):
        obj = self.make()
        self.base.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.doc.recompute()
        self.assertAlmostEqual(obj.FemMesh.BoundBox.XMin, 100.0)
        self.assertTrue(obj.Placement.isIdentity())

    def test_an_error_keeps_the_old_mesh_and_says_what_is_wrong(self):
        obj = self.make()
        quads = obj.FemMesh.QuadrangleCount
        apart = anisoquad.make_source(self.doc, self.base, [0, 30], anisotropy=2)
        for change, text in (({"Sources": [apart]}, "30"), ({"Sources": [self.base]}, "is not a source"),
                             ({"Sources": [], "FeatureEdges": [1]}, "FeatureEdges"), ({"FeatureEdges": [], "Base": None}, "Base")):
            with self.subTest(text):
                for name, value in change.items():
                    setattr(obj, name, value)
                self.doc.recompute()
                self.assertIn("Invalid", obj.State)
                self.assertIn(text, obj.getStatusString())
                self.assertEqual(obj.FemMesh.QuadrangleCount, quads)
        obj.Base = self.base
        self.doc.recompute()
        self.assert_filled(obj)

    def test_sizes_per_vertex_are_kept(self):
        options = anisoquad.Options(vertex_size=[1.0] * self.base.Mesh.CountPoints)
        obj = self.make(options=options)
        self.assert_filled(obj)
        self.assertEqual(obj.VertexSize, options.vertex_size)

    def test_the_preview_shows_the_rows_that_are_built(self):
        obj = self.make(sources=[LOWER_EDGE], passes=[(2, 2)])
        job = MeshJob.of(obj)
        ends, pass_ = job.preview()
        mesh = job.run().mesh
        quads = mesh.quads[mesh.row > 0]
        edges = {tuple(sorted(pair)) for quad in quads.tolist() for pair in zip(quad, quad[1:] + quad[:1])}
        self.assertEqual(len(ends), len(edges))
        self.assertEqual(set(pass_.tolist()), {1})
        self.assertAlmostEqual(ends[:, :, 1].min(), 0.0)

    def test_sources_with_passes_of_their_own(self):
        sources = [anisoquad.Source(LOWER_EDGE, passes=[(3, 1)], sides="left"), [42, 43, 44, 45, 46, 47, 48]]
        obj = self.make(sources=sources, passes=[(2, 1)])
        self.assert_filled(obj)
        ratios = {entry["source"]: entry["ratio"] for entry in json.loads(obj.Report)["passes"]}
        self.assertEqual(ratios, {0: 3, 1: 2})

    def test_what_can_not_be_read_makes_no_object(self):
        for keywords in ({"passes": "x"}, {"sources": [["a"]]}, {"passes": [2], "anisotropy": 2}):
            with self.subTest(keywords), self.assertRaises(anisoquad.MeshError):
                anisoquad.make_quad_mesh(self.doc, base=self.base, **keywords)
        self.assertEqual(len(self.doc.Objects), 1)


class SaveAndReopen(DocumentTest):
    def test_everything_is_kept_and_nothing_is_recomputed(self):
        obj = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[LOWER_EDGE], passes=[(2, 1)], name="Quads")
        self.doc.recompute()
        before = self.state(obj)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            self.close()
            self.doc = FreeCAD.openDocument(path)
        obj = self.doc.getObject("Quads")
        self.assertEqual(self.state(obj), before)
        self.assertEqual(self.doc.recompute(), 0)
        obj.Sources[0].Passes = "3:1"
        self.doc.recompute()
        self.assertEqual(obj.getStatusString(), "Valid")
        self.assertIn("1:3", obj.RowsPerPass[0])

    @staticmethod
    def state(obj):
        mesh = obj.FemMesh
        return (
            type(obj.Proxy).__module__,
            [(source.Name, source.Vertices, source.Passes, source.Length) for source in obj.Sources],
            obj.Report,
            obj.SchemaVersion,
            {node: tuple(point) for node, point in mesh.Nodes.items()},
            {face: mesh.getElementNodes(face) for face in mesh.Faces},
            {mesh.getGroupName(group): sorted(mesh.getGroupElements(group)) for group in mesh.Groups},
        )


if __name__ == "__main__":
    unittest.main()
