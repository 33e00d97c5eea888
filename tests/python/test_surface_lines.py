"""Lines on surfaces: rays, suggestions, imprint."""

import unittest

import numpy as np
import surfaces

from anisoquad import MeshError, Source, quad_mesh
from anisoquad.surface_lines import SurfaceLines, cut_at_ends, edges_of, imprint


class Rays(unittest.TestCase):
    def test_a_ray_from_above_meets_the_upper_side_of_the_wing(self):
        points, triangles, leading_edge = surfaces.wing()
        lines = SurfaceLines(points, triangles)
        hit = lines.edge_on_ray((0.9, 0.5, 1.0), (0, 0, -1))
        self.assertGreater(hit.point[2], 0.0)
        self.assertTrue(set(hit.edge) <= set(triangles[hit.facet].tolist()))
        below = lines.edge_on_ray((0.9, 0.5, -1.0), (0, 0, 1))
        self.assertLess(below.point[2], 0.0)
        self.assertIsNone(lines.edge_on_ray((5, 5, 1), (0, 0, -1)))

    def test_the_leading_edge_is_met_beside_the_outline(self):
        points, triangles, leading_edge = surfaces.wing()
        a, b = points[leading_edge[30]], points[leading_edge[31]]
        outside = 0.5 * (a + b) + [-0.002, 0.002, 1.0]
        hit = SurfaceLines(points, triangles).edge_on_ray(outside, (0, 0, -1), reach=0.006)
        self.assertEqual(set(hit.edge), set(leading_edge[30:32]))


class Suggestions(unittest.TestCase):
    def test_the_leading_edge_of_both_wings_comes_first(self):
        for name in ("wing_delta", "wing_swept"):
            with self.subTest(name):
                points, triangles, leading_edge = surfaces.wing(name)
                first = SurfaceLines(points, triangles).suggest()[0]
                self.assertIn(first, (leading_edge, leading_edge[::-1]))

    def test_nothing_on_a_plane(self):
        self.assertEqual(SurfaceLines(*surfaces.plane()).suggest(), [])


class CutAtEnds(unittest.TestCase):
    def test_a_line_is_cut_where_another_one_ends_on_it(self):
        self.assertEqual(cut_at_ends([[1, 2, 3, 4], [9, 8, 3]]), [[1, 2, 3], [3, 4], [9, 8, 3]])

    def test_a_closed_line_becomes_open_pieces(self):
        self.assertEqual(cut_at_ends([[1, 2, 3, 4, 1], [9, 3]]), [[3, 4, 1], [1, 2, 3], [9, 3]])
        self.assertEqual(cut_at_ends([[1, 2, 3, 4, 1], [9, 3], [2, 8]]), [[2, 3], [3, 4, 1, 2], [9, 3], [2, 8]])
        self.assertEqual(cut_at_ends([[1, 2, 3, 1], [7, 8]]), [[1, 2, 3, 1], [7, 8]])

    def test_lines_that_meet_at_their_ends_stay(self):
        paths = [[1, 2, 3], [3, 4, 5], [6, 7]]
        self.assertEqual(cut_at_ends(paths), paths)

    def test_what_is_suggested_together_can_be_meshed_together(self):
        points, triangles, _ = surfaces.wing("wing_swept")
        chosen = SurfaceLines(points, triangles).suggest()
        with self.assertRaises(MeshError):
            quad_mesh(points, triangles, [Source(line, anisotropy=4) for line in chosen])
        mesh = quad_mesh(points, triangles, [Source(line, anisotropy=4) for line in cut_at_ends(chosen)])
        self.assertTrue(mesh.valid)


class Imprint(unittest.TestCase):
    STAIRS = [28, 29, 43, 44, 58, 59, 73, 74]  # over cells and diagonals of the plane in turn

    def setUp(self):
        self.points, _ = surfaces.plane()
        j, i = np.divmod(np.arange(120), 12)
        a = j * 13 + i  # all diagonals go the same way, so that the stairs are edges
        self.triangles = np.concatenate([np.column_stack([a, a + 1, a + 14]), np.column_stack([a, a + 14, a + 13])]).astype(np.int32)

    def test_a_staircase_becomes_straight(self):
        lines = SurfaceLines(self.points, self.triangles)
        self.assertTrue(lines.is_zigzag(self.STAIRS))
        points, triangles, path = imprint(self.points, self.triangles, self.STAIRS)
        after = SurfaceLines(points, triangles)
        self.assertFalse(after.is_zigzag(path))
        straight = np.linalg.norm(self.points[self.STAIRS[-1]] - self.points[self.STAIRS[0]])
        self.assertLess(after.length(path), 1.01 * straight)
        self.assertTrue(np.array_equal(points[: len(self.points)], self.points))
        mesh = quad_mesh(points, triangles, [Source(path, passes=[(2, 1)])])
        self.assertTrue(mesh.valid)

    def test_other_lines_are_kept(self):
        other = [92, 93, 94, 95]
        points, triangles, _ = imprint(self.points, self.triangles, self.STAIRS[:4], keep=[other])
        sides = {frozenset(pair) for t in triangles.tolist() for pair in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
        for edge in edges_of([other]):
            self.assertIn(frozenset(edge), sides)

    def test_what_is_no_path(self):
        with self.assertRaises(MeshError):
            imprint(self.points, self.triangles, [0, 40])


if __name__ == "__main__":
    unittest.main()
