"""Measures of quads against figures known by hand."""

import math
import unittest

import numpy as np

from anisoquad.quality import scaled_jacobian


def measure(*corners):
    return scaled_jacobian(np.array([(*corner, 0.0)[:3] for corner in corners]), np.array([[0, 1, 2, 3]]))[0]


class ScaledJacobian(unittest.TestCase):
    def test_rectangles_have_one(self):
        self.assertAlmostEqual(measure((0, 0), (1, 0), (1, 1), (0, 1)), 1.0)
        self.assertAlmostEqual(measure((0, 0), (16, 0), (16, 1), (0, 1)), 1.0)

    def test_a_rhombus_has_the_sine_of_its_angle(self):
        c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
        self.assertAlmostEqual(measure((0, 0), (1, 0), (1 + c, s), (c, s)), s)

    def test_concave_and_folded_quads_are_not_positive(self):
        self.assertLess(measure((0, 0), (1, 0), (0.2, 0.2), (0, 1)), 0.0)
        self.assertLessEqual(measure((0, 0), (1, 0), (0, 1), (1, 1)), 0.0)

    def test_a_quad_without_area_is_not_valid(self):
        self.assertLessEqual(measure((0, 0), (1, 0), (2, 0), (3, 0)), 0.0)
        self.assertLessEqual(measure((0, 0), (0, 0), (0, 0), (0, 0)), 0.0)
