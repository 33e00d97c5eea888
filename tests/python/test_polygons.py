"""Facets with more than three corners become triangles."""

import unittest

import numpy as np
from anisoquad.polygons import split_polygons


def areas(points, triangles):
    a, b, c = (np.asarray(points, float)[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)[:, 2] / 2


class SplitPolygons(unittest.TestCase):
    def test_triangles_stay(self):
        triangles, split = split_polygons(np.zeros((4, 3)), [[0, 1, 2], [1, 3, 2]])
        self.assertEqual((triangles.tolist(), split), ([[0, 1, 2], [1, 3, 2]], 0))

    def test_a_quad_is_cut_along_its_shorter_diagonal(self):
        points = np.array([[0, 0, 0], [3, 0, 0], [4, 1, 0], [1, 1, 0]], float)
        triangles, split = split_polygons(points, [[0, 1, 2, 3]])
        self.assertEqual(split, 1)
        self.assertEqual({tuple(sorted(triangle)) for triangle in triangles.tolist()}, {(0, 1, 3), (1, 2, 3)})

    def test_a_quad_with_a_notch_is_cut_at_the_notch(self):
        # The shorter diagonal, from 1 to 3, lies outside.
        points = np.array([[0, 0, 0], [1, 3, 0], [0, 1, 0], [-1, 3, 0]], float)
        triangles, _ = split_polygons(points, [[0, 1, 2, 3]])
        self.assertTrue(np.all(areas(points, triangles) > 0))
        self.assertAlmostEqual(areas(points, triangles).sum(), 1.0)

    def test_any_outline_is_covered_once_and_keeps_its_side(self):
        # A comb, in both directions.
        outline = [(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (3, 1), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        points = np.array([(x, y, 0.0) for x, y in outline])
        for ids, sign in ((list(range(12)), 1), (list(range(11, -1, -1)), -1)):
            triangles, split = split_polygons(points, [ids])
            self.assertEqual((len(triangles), split), (10, 1))
            self.assertTrue(np.all(sign * areas(points, triangles) > 0))
            self.assertAlmostEqual(abs(areas(points, triangles).sum()), 11.0)

    def test_ids_that_are_no_points_are_left_to_the_core(self):
        triangles, _ = split_polygons(np.zeros((3, 3)), [[0, 1, 2, 7]])
        self.assertEqual(triangles.tolist(), [[0, 1, 2], [0, 2, 7]])

    def test_fewer_than_three_corners_are_an_error(self):
        with self.assertRaisesRegex(ValueError, "2 corners"):
            split_polygons(np.zeros((3, 3)), [[0, 1]])


if __name__ == "__main__":
    unittest.main()
