"""The order in which vertices and facets are given changes the mesh a little, its size and quality hardly."""

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
            return result.report

        first = mesh(points, triangles, line)
        for seed in range(2):
            other_points, other_triangles, new_id = shuffled(points, triangles, seed)
            report = mesh(other_points, other_triangles, None if line is None else new_id[line].tolist())
            self.assertEqual(report["patches"], first["patches"])
            self.assertEqual(report["feature_lines"], first["feature_lines"])
            self.assertAlmostEqual(report["quads"] / first["quads"], 1.0, delta=0.15)
            self.assertAlmostEqual(report["scaled_jacobian"]["mean"], first["scaled_jacobian"]["mean"], delta=0.02)
            self.assertAlmostEqual(report["scaled_jacobian"]["p5"], first["scaled_jacobian"]["p5"], delta=0.08)
            self.assertAlmostEqual(report["regular_percent"], first["regular_percent"], delta=10.0)
            self.assertEqual({(p["side"], p["pass"]): p["rows"] for p in report["passes"]},
                             {(p["side"], p["pass"]): p["rows"] for p in first["passes"]})

    def test_isotropic(self):
        for make in (lambda: surfaces.sphere(14), lambda: surfaces.torus(48, 20), lambda: surfaces.cube(10), lambda: surfaces.plane(24, 20)):
            self.compare(*make())

    def test_a_wing_with_rows(self):
        self.compare(*surfaces.wing(), passes=[4, 2])


if __name__ == "__main__":
    unittest.main()
