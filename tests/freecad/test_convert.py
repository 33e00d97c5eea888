"""Meshes to numpy and back."""

import base64
import threading
import time
import unittest

import Fem
import FreeCAD
import numpy as np
from documents import square

from anisoquad import _core, convert, quad_mesh
from anisoquad.objects import stored_result


class MeshToArrays(unittest.TestCase):
    def test_the_same_as_topology(self):
        mesh = square()
        points, triangles, _ = convert.mesh_content(mesh)
        expected_points, expected_triangles = mesh.Topology
        self.assertTrue(np.array_equal(points, [list(point) for point in expected_points]))
        self.assertTrue(np.array_equal(triangles, expected_triangles))

    def test_the_placement_is_honoured(self):
        placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 30))
        points = convert.moved(convert.mesh_content(square())[0], placement)
        expected = [list(placement.multVec(point)) for point in square().Topology[0]]
        self.assertTrue(np.allclose(points, expected, rtol=0, atol=1e-12))


class Signature(unittest.TestCase):
    def test_it_differs_with_points_and_facets(self):
        moved_point, without_facet = square(), square()
        moved_point.setPoint(8, FreeCAD.Vector(1.2, 1.1, 0))  # inside the square: neither area nor box changes
        without_facet.removeFacets([0])
        signatures = [convert.mesh_content(mesh)[2] for mesh in (square(), moved_point, without_facet)]
        self.assertEqual(len(set(signatures)), 3)
        self.assertEqual(convert.mesh_content(square())[2], signatures[0])

    def test_it_differs_with_the_placement(self):
        there = FreeCAD.Placement(FreeCAD.Vector(0, 0, 1e-3), FreeCAD.Rotation())
        self.assertNotEqual(convert.placement_signature(there), convert.placement_signature(FreeCAD.Placement()))


class FemMesh(unittest.TestCase):
    def test_ids_count_from_one_in_the_arrays_order(self):
        mesh = quad_mesh(*convert.mesh_content(square())[:2])
        fem_mesh = convert.fem_mesh_of(mesh)
        self.assertEqual(fem_mesh.QuadrangleCount, len(mesh.quads))
        self.assertEqual(fem_mesh.NodeCount, len(mesh.points))
        nodes = fem_mesh.Nodes
        for index in (0, len(mesh.points) - 1):
            self.assertEqual(list(nodes[index + 1]), mesh.points[index].tolist())
        for index in (0, len(mesh.quads) - 1):
            self.assertEqual(set(fem_mesh.getElementNodes(index + 1)), set((mesh.quads[index] + 1).tolist()))

    def test_wrong_arrays_are_refused(self):
        for points, quads in ((np.zeros((3, 2)), np.zeros((1, 4), int)), (np.zeros((4, 3)), np.zeros((1, 3), int))):
            with self.assertRaises(ValueError):
                _core.fill_fem_mesh(None, points, quads)

    def test_other_threads_run_while_it_is_filled(self):
        points, quads = np.zeros((200_000, 3)), np.empty((0, 4), np.int32)
        points[:, 0] = np.arange(len(points))
        thread = threading.Thread(target=_core.fill_fem_mesh, args=(Fem.FemMesh(), points, quads))
        started = last = time.monotonic()
        longest = 0.0
        thread.start()
        while thread.is_alive():
            time.sleep(0.001)
            now = time.monotonic()
            longest, last = max(longest, now - last), now
        self.assertLess(longest, 0.5 * (last - started))


class StoredResult(unittest.TestCase):
    def test_it_is_read_again_also_as_older_files_hold_it(self):
        mesh = quad_mesh(*convert.mesh_content(square())[:2])
        text = stored_result.pack(mesh)
        data = base64.b64decode(text.split(":")[1])
        for stored in (text, base64.b85encode(data).decode("ascii")):
            again = stored_result.unpack(stored, mesh.points, mesh.quads, "{}")
            for name in ("row", "patch", "node_line", "line_edges"):
                self.assertTrue(np.array_equal(getattr(again, name), getattr(mesh, name)), name)
