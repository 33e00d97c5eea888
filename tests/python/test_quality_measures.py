"""The measures of panels agree with the report of the core."""

import unittest

import numpy as np
import surfaces

from anisoquad import Source, quad_mesh
from anisoquad.quality_measures import MEASURES


class Measures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        points, triangles, leading_edge = surfaces.wing()
        cls.mesh = quad_mesh(points, triangles, [Source(leading_edge, anisotropy=4)])

    def test_they_are_those_of_the_report(self):
        for name in ("scaled_jacobian", "aspect_ratio", "skew"):
            with self.subTest(name):
                values, report = MEASURES[name].compute(self.mesh), self.mesh.report[name]
                for key, value in (("min", values.min()), ("max", values.max()), ("mean", values.mean())):
                    self.assertAlmostEqual(report[key], value, places=9)
                self.assertEqual(MEASURES[name].worst_ids(values, 1)[0], report["worst"])

    def test_size_is_that_of_a_square_of_the_same_area(self):
        square = type(self.mesh)(np.array([[0, 0, 0], [4, 0, 0], [4, 1, 0], [0, 1, 0]], float), np.array([[0, 1, 2, 3]]), *[None] * 7, {})
        self.assertAlmostEqual(MEASURES["size"].compute(square)[0], 2.0)

    def test_bad_is_red_and_good_is_blue(self):
        for name, bad, good in (("scaled_jacobian", 0.0, 1.0), ("skew", 1.0, 0.0), ("aspect_ratio", 9.0, 1.0)):
            colours = MEASURES[name].colours(np.array([bad, good]))
            self.assertGreater(colours[0][0], colours[0][2], name)
            self.assertGreater(colours[1][2], colours[1][0], name)

    def test_rows_have_no_worst(self):
        values = MEASURES["row"].compute(self.mesh)
        self.assertEqual(len(MEASURES["row"].worst_ids(values, 5)), 0)
        self.assertGreater(values.max(), 0)

    def test_one_value_for_all_can_be_coloured(self):
        self.assertTrue(np.isfinite(MEASURES["size"].colours(np.full(3, 2.0))).all())


if __name__ == "__main__":
    unittest.main()
