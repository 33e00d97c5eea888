"""Meshes to numpy and back."""

import unittest

import FreeCAD
import numpy as np
from documents import square

from anisoquad import convert, quad_mesh


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
        from anisoquad import _core

        for points, quads in ((np.zeros((3, 2)), np.zeros((1, 4), int)), (np.zeros((4, 3)), np.zeros((1, 3), int))):
            with self.assertRaises(ValueError):
                _core.fill_fem_mesh(None, points, quads)
