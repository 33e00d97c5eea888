"""Quads of eight nodes."""

import unittest

import numpy as np
import surfaces

from anisoquad import Options, Source, quad_mesh
from anisoquad.second_order import second_order


class SecondOrder(unittest.TestCase):
    def make(self, points, triangles, sources=()):
        mesh = quad_mesh(points, triangles, sources)
        return mesh, second_order(mesh, points, triangles, Options().feature_angle, [source.vertices for source in sources])

    def test_every_edge_has_one_node(self):
        mesh, quadratic = self.make(*surfaces.torus())
        edges = {tuple(sorted(pair)) for quad in mesh.quads.tolist() for pair in zip(quad, quad[1:] + quad[:1])}
        self.assertEqual(len(quadratic.points), len(mesh.points) + len(edges))
        self.assertTrue(np.array_equal(quadratic.points[: len(mesh.points)], mesh.points))
        self.assertTrue(np.array_equal(quadratic.quads[:, :4], mesh.quads))
        self.assertEqual(sorted(set(quadratic.quads[:, 4:].ravel().tolist())), list(range(len(mesh.points), len(quadratic.points))))

    def test_they_are_nearer_to_the_sphere_than_the_chords(self):
        points, triangles = surfaces.sphere(24)
        mesh, quadratic = self.make(points, triangles)
        corners = quadratic.points[quadratic.quads[:, :4]]
        chords = 0.5 * (corners + np.roll(corners, -1, axis=1))
        middles = quadratic.points[quadratic.quads[:, 4:]]
        off = [np.abs(1.0 - np.linalg.norm(place, axis=2)).mean() for place in (middles, chords)]
        self.assertLess(off[0], 0.5 * off[1])

    def test_those_of_feature_edges_are_on_the_lines(self):
        _, quadratic = self.make(*surfaces.cylinder())
        points, _ = surfaces.cylinder()
        for height in (0.0, points[:, 2].max()):
            rim = quadratic.points[np.abs(quadratic.points[:, 2] - height) < 1e-12]
            radius = np.linalg.norm(rim[:, :2], axis=1)
            self.assertTrue((radius <= 1.0 + 1e-9).all() and (radius >= np.cos(np.pi / 24) - 1e-9).all(), "on the input's polygon")

    def test_nodes_of_edges(self):
        mesh, quadratic = self.make(*surfaces.plane(), [Source(list(range(13)), passes=[2])])
        edges = mesh.line_edges[:, :2]
        with_middles = quadratic.with_middles(edges)
        middles = 0.5 * (mesh.points[edges[:, 0]] + mesh.points[edges[:, 1]])
        self.assertTrue(np.allclose(quadratic.points[with_middles[:, 2]], middles, atol=1e-12))


if __name__ == "__main__":
    unittest.main()
