"""The order in which vertices and facets are given changes nothing: the mesh is the same to the last bit."""

import unittest

import invariants
import numpy as np
import surfaces

import anisoquad


def shuffled(points, triangles, seed):
    """(points, triangles, new id of each vertex): vertices and facets in random order, facets begin at a random corner."""
    random = np.random.default_rng(seed)
    order = random.permutation(len(points))
    new_id = np.empty(len(points), np.int64)
    new_id[order] = np.arange(len(points))
    facets = new_id[triangles][random.permutation(len(triangles))]
    turn = random.integers(0, 3, len(facets))
    return points[order], facets[np.arange(len(facets))[:, None], (np.arange(3) + turn[:, None]) % 3], new_id


class Order(unittest.TestCase):
    def compare(self, points, triangles, line=None, passes=None):
        def mesh(points, triangles, line):
            sources = [] if line is None else [anisoquad.Source(line, passes=passes)]
            result = anisoquad.quad_mesh(points, triangles, sources)
            invariants.check(self, points, triangles, result)
            return result

        first = mesh(points, triangles, line)
        for seed in range(2):
            other_points, other_triangles, new_id = shuffled(points, triangles, seed)
            other = mesh(other_points, other_triangles, None if line is None else new_id[line].tolist())
            np.testing.assert_array_equal(other.points, first.points)
            np.testing.assert_array_equal(other.quads, first.quads)
            np.testing.assert_array_equal(other.row, first.row)
            kept = first.node_input >= 0
            np.testing.assert_array_equal(other.node_input[kept], new_id[first.node_input[kept]])

    def test_isotropic(self):
        for make in (lambda: surfaces.sphere(14), lambda: surfaces.torus(48, 20), lambda: surfaces.cube(10), lambda: surfaces.plane(24, 20)):
            self.compare(*make())

    def test_a_wing_with_rows(self):
        self.compare(*surfaces.wing(), passes=[4, 2])


if __name__ == "__main__":
    unittest.main()
