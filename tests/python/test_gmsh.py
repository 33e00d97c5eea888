"""Triangles of a CAD file by Gmsh: size and curvature, errors, cancel, the command."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from invariants import check
from test_cad import TUBE, off_tube

import anisoquad
from anisoquad import gmsh
from anisoquad.cad import CadShape, CadSurface, has_cad


def longest_edge(points, triangles):
    corners = points[triangles]
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max()


class WithoutGmsh(unittest.TestCase):
    def test_the_error_names_the_package(self):
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            self.assertFalse(gmsh.has_gmsh())
            with self.assertRaises(anisoquad.MeshError) as caught:
                gmsh.triangulate(TUBE)
        self.assertEqual(caught.exception.code, "no_gmsh")
        self.assertIn("apt-get install gmsh", str(caught.exception))


@unittest.skipUnless(gmsh.has_gmsh(), "Gmsh is not installed")
class Triangles(unittest.TestCase):
    def test_size_and_curvature(self):
        coarse, fine = gmsh.triangulate(TUBE, size=5.0), gmsh.triangulate(TUBE, size=2.0)
        self.assertGreater(len(fine[1]), 2 * len(coarse[1]))
        self.assertLess(longest_edge(*fine), 2.0 * 1.6)
        turning = gmsh.triangulate(TUBE, size=5.0, angle=6.0)
        self.assertGreater(len(turning[1]), 2 * len(coarse[1]))
        points, triangles = fine
        self.assertEqual((points.dtype, triangles.dtype), (np.float64, np.int32))
        self.assertLess(off_tube(points).max(), 1e-6)
        self.assertEqual(sorted(np.unique(triangles)), list(range(len(points))))

    def test_the_same_input_gives_the_same_bytes(self):
        first, second = gmsh.triangulate(TUBE, size=3.0), gmsh.triangulate(TUBE, size=3.0)
        self.assertEqual([array.tobytes() for array in first], [array.tobytes() for array in second])

    def test_what_is_no_shape(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "nonsense.step"
            path.write_text("nonsense")
            with self.assertRaises(anisoquad.MeshError) as caught:
                gmsh.triangulate(path)
            self.assertEqual(caught.exception.code, "face_not_meshable")
            with self.assertRaises(anisoquad.MeshError) as caught:
                gmsh.triangulate(Path(folder) / "missing.brep")
            self.assertEqual(caught.exception.code, "unreadable_file")

    def test_cancel_ends_the_program(self):
        started, told = [], []
        start = subprocess.Popen

        def note(*arguments, **keywords):
            started.append(start(*arguments, **keywords))
            return started[-1]

        def stop(stage, fraction):
            told.append((stage, fraction))
            return len(told) < 5

        with mock.patch.object(subprocess, "Popen", note), self.assertRaises(anisoquad.Cancelled):
            gmsh.triangulate(TUBE, size=0.02, progress=stop)
        self.assertEqual(len(told), 5)
        self.assertEqual({stage for stage, _ in told}, {gmsh.STAGE})
        self.assertTrue(all(0.0 <= fraction <= 1.0 for _, fraction in told))
        self.assertLess(started[0].returncode, 0, "killed by a signal")

    @unittest.skipUnless(has_cad(), "built without OpenCASCADE")
    def test_quads_on_the_shape(self):
        shape = CadShape.from_file(TUBE)
        points, triangles = gmsh.triangulate(TUBE, size=3.0)
        mesh = anisoquad.quad_mesh(points, triangles, surface=CadSurface(shape, points, triangles))
        check(self, points, triangles, mesh)
        self.assertLess(off_tube(mesh.points).max(), 1e-7 * shape.diagonal)
        self.assertEqual(mesh.report["warnings"], [])

    @unittest.skipUnless(has_cad(), "built without OpenCASCADE")
    def test_the_command(self):
        environment = {**os.environ, "PYTHONPATH": str(Path(anisoquad.__file__).parents[1])}
        wing = TUBE.parent / "wing_delta.off"
        cases = (([TUBE], 0), ([TUBE, "--source-edges", 1, "--passes", 2], 0), ([TUBE, "--deflection", 1], 2), ([wing], 2))
        for arguments, code in cases:
            with self.subTest(arguments), tempfile.TemporaryDirectory() as folder:
                command = [sys.executable, "-m", "anisoquad", arguments[0], Path(folder) / "out.inp", *arguments[1:], "--triangulator", "gmsh", "--size", 4]
                run = subprocess.run([str(part) for part in command], env=environment, capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, code, run.stderr)
                self.assertEqual(len(run.stderr.splitlines()), 0 if code == 0 else 1)


if __name__ == "__main__":
    unittest.main()
