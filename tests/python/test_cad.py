"""CAD shapes without FreeCAD: reading, linking, sources by edges, nodes on the shape, the command."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from invariants import check

import anisoquad
from anisoquad.cad import CadShape, CadSurface, has_cad
from anisoquad.groups import face_groups, line_groups

DATA = Path(__file__).resolve().parents[1] / "data"
TUBE = DATA / "tube.brep"  # radius 10, height 30, on the plane z = 0, its axis that of z


def off_tube(points):
    """Distances from the tube's surface, caps included."""
    radius = np.hypot(points[:, 0], points[:, 1])
    side = np.abs(radius - 10.0)
    caps = np.minimum(np.abs(points[:, 2]), np.abs(points[:, 2] - 30.0))
    return np.where(radius < 10.0 - 1e-6, caps, side)


@unittest.skipUnless(has_cad(), "built without OpenCASCADE")
class Tube(unittest.TestCase):
    def setUp(self):
        self.shape = CadShape.from_file(TUBE)
        self.points, self.triangles = self.shape.triangulate()
        self.surface = CadSurface(self.shape, self.points, self.triangles)
        self.rim = next(name for name in ("Edge1", "Edge2", "Edge3") if self.is_rim(name))

    def is_rim(self, name):
        line = self.points[self.surface.path(name)]
        return bool((line[:, 2] > 29.0).all())

    def test_all_nodes_lie_on_the_shape(self):
        mesh = anisoquad.quad_mesh(self.points, self.triangles, options=anisoquad.Options(size=3.0), surface=self.surface)
        check(self, self.points, self.triangles, mesh)
        self.assertLess(off_tube(mesh.points).max(), 1e-7 * self.shape.diagonal)
        alone = anisoquad.quad_mesh(self.surface.points, self.triangles, options=anisoquad.Options(size=3.0))
        self.assertGreater(off_tube(alone.points).max(), 1e-7 * self.shape.diagonal)

    def test_a_closed_edge_is_a_source(self):
        path = self.surface.path(self.rim)
        self.assertEqual(path[0], path[-1])
        source = anisoquad.Source(path, anisotropy=4)
        mesh = anisoquad.quad_mesh(self.points, self.triangles, [source], anisoquad.Options(size=3.0), surface=self.surface)
        check(self, self.points, self.triangles, mesh)
        self.assertEqual({entry["side"] for entry in mesh.report["passes"]}, {"left", "right"})
        self.assertLess(off_tube(mesh.points).max(), 1e-7 * self.shape.diagonal)
        self.assertEqual(self.surface.path(self.rim, reverse=True), path[::-1])

    def test_groups_are_those_of_faces_and_edges(self):
        mesh = anisoquad.quad_mesh(self.points, self.triangles, options=anisoquad.Options(size=3.0), surface=self.surface)
        faces = {name: quads for name, quads in face_groups(mesh).items() if name.startswith("Face")}
        self.assertEqual(sorted(faces), ["Face1", "Face2", "Face3"])
        self.assertEqual(sum(map(len, faces.values())), len(mesh.quads))
        rim = line_groups(mesh)[self.rim]
        self.assertTrue((np.abs(mesh.points[rim][:, :, 2] - 30.0) < 1e-9).all())
        self.assertEqual(len(np.unique(rim)), len(rim), "a closed line has as many nodes as edges")

    def test_points_are_told_apart(self):
        entities = self.surface.entities()
        self.assertEqual(sum(name.startswith("Vertex") for name in entities), 2)
        self.assertTrue(all(entities[vertex].startswith(("Edge", "Vertex")) for vertex in self.surface.path(self.rim)))

    def test_what_does_not_belong_together(self):
        cases = ((self.points + [0.0, 0.0, 5.0], self.triangles, "shape_mismatch"), (2.0 * self.points, self.triangles, "shape_mismatch"),
                 (self.points, self.triangles[:-3], "shape_mismatch"), (self.points, self.without_face(2), "face_not_meshable"), (self.points, self.triangles + 10**6, "index_out_of_range"))
        for points, triangles, code in cases:
            with self.subTest(code):
                with self.assertRaises(anisoquad.MeshError) as caught:
                    CadSurface(self.shape, points, triangles)
                self.assertEqual(caught.exception.code, code)
                self.assertTrue(caught.exception.ids)

    def without_face(self, face):
        return self.triangles[self.surface.facet_face != face]

    def test_folds_of_the_triangles_are_counted_and_told_where_quads_are_turned_over(self):
        self.assertEqual(self.surface.count_folds(), 0)
        # A triangle of the upper cap becomes three round a point beyond one of its edges.
        cap = np.flatnonzero((self.points[self.triangles][:, :, 2] > 29.0).all(axis=1))
        a, b, c = self.triangles[cap[0]]
        beyond = 0.5 * (self.points[a] + self.points[b]) + 1e-2 * (0.5 * (self.points[a] + self.points[b]) - self.points[c])
        n = len(self.points)
        triangles = np.concatenate([np.delete(self.triangles, cap[0], axis=0), [[a, b, n], [b, c, n], [c, a, n]]])
        folded = CadSurface(self.shape, np.concatenate([self.points, [beyond]]), triangles)
        self.assertIn(folded.count_folds(), (2, 3))  # the third, where the edge lies within the cap

        def turned_over(*arguments):
            result = core(*arguments)
            result["report"]["inverted"] = 1
            return result

        core = anisoquad.meshing._core.quad_mesh
        with mock.patch.object(anisoquad.meshing._core, "quad_mesh", turned_over):
            for surface, told in ((self.surface, False), (folded, True)):
                mesh = anisoquad.quad_mesh(surface.points, surface.triangles, surface=surface)
                self.assertEqual(any("folded over" in text for text in mesh.report["warnings"]), told)

    def test_edges_that_are_not_there(self):
        for edges in ("Edge9", "Face1", "0", ["Edge1", "Edge2", "Edge3"], []):
            with self.subTest(edges):
                with self.assertRaises(anisoquad.MeshError) as caught:
                    self.surface.path(edges)
                self.assertEqual(caught.exception.code, "invalid_source")

    def test_the_same_input_gives_the_same_bytes(self):
        first, second = (anisoquad.quad_mesh(self.points, self.triangles, options=anisoquad.Options(size=4.0),
                                             surface=CadSurface(self.shape, self.points, self.triangles)) for _ in range(2))
        self.assertEqual(first.points.tobytes(), second.points.tobytes())
        self.assertEqual(first.quads.tobytes(), second.quads.tobytes())


@unittest.skipUnless(has_cad(), "built without OpenCASCADE")
class Command(unittest.TestCase):
    def run_command(self, *arguments):
        environment = {**os.environ, "PYTHONPATH": str(Path(anisoquad.__file__).parents[1])}
        return subprocess.run([sys.executable, "-m", "anisoquad", *map(str, arguments)], env=environment,
                              capture_output=True, text=True, check=False)

    def test_a_cad_file_with_a_source_on_an_edge(self):
        with tempfile.TemporaryDirectory() as folder:
            out, report = Path(folder) / "tube.inp", Path(folder) / "report.json"
            run = self.run_command(TUBE, out, "--source-edges", 1, "--passes", "2", "--size", 4, "--report", report)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(json.loads(report.read_text())["patches"], 3)
            text = out.read_text().upper()
        self.assertIn("FACE1", text)
        self.assertIn("EDGE1", text)

    def test_repair_takes_invalid_faces_as_they_are(self):
        with tempfile.TemporaryDirectory() as folder:
            broken, out, report = (Path(folder) / name for name in ("broken.brep", "out.vtu", "report.json"))
            broken.write_text(TUBE.read_text().replace("\n10 -2.44929359829471e-15 30\n", "\n10.001 0 30\n"))  # a vertex off its edges
            run = self.run_command(broken, out, "--size", 4)
            self.assertEqual(run.returncode, 2)
            self.assertIn("invalid faces", run.stderr)
            run = self.run_command(broken, out, "--size", 4, "--repair", "--report", report)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(any("taken as they are: Face" in warning for warning in json.loads(report.read_text())["warnings"]))

    def test_bad_input_ends_with_2_and_one_line(self):
        for arguments in ((TUBE, "--source-edges", 9), (TUBE, "--source-edges", "1,x"), (DATA / "missing.step",),
                          (DATA / "wing_delta.off", "--source-edges", 1), (TUBE, "--passes", "2")):
            with self.subTest(arguments), tempfile.TemporaryDirectory() as folder:
                run = self.run_command(arguments[0], Path(folder) / "out.vtu", *arguments[1:])
                self.assertEqual(run.returncode, 2)
                self.assertEqual(len(run.stderr.strip().splitlines()), 1, run.stderr)


if __name__ == "__main__":
    unittest.main()
