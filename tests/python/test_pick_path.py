"""What clicks mean, without a window."""

import unittest

import surfaces

from anisoquad.pick_path import PickPath
from anisoquad.surface_lines import SurfaceLines


class OnAPlane(unittest.TestCase):
    """A rectangle of 12 × 10 cells: point (i, j) has the id 13·j + i."""

    def setUp(self):
        self.path = PickPath(SurfaceLines(*surfaces.plane()))

    def test_a_click_starts_and_another_extends(self):
        self.assertTrue(self.path.click((15, 16)))
        self.assertEqual(self.path.vertices, [15, 16])
        self.assertTrue(self.path.click((18, 19)))
        self.assertEqual(self.path.vertices, [15, 16, 17, 18, 19])
        self.assertEqual((self.path.edge_count, self.path.length), (4, 4.0))

    def test_it_grows_at_the_nearer_end(self):
        self.path.click((18, 19))
        self.path.click((14, 15))
        self.assertEqual(self.path.vertices, [14, 15, 16, 17, 18, 19])

    def test_it_does_not_cross_itself(self):
        for edge in ((80, 81), (84, 85), (58, 59), (56, 57)):
            self.path.click(edge)
        before = list(self.path.vertices)
        self.path.click((95, 96))
        inner = self.path.vertices[:-1] if self.path.closed else self.path.vertices
        self.assertEqual(len(inner), len(set(inner)))
        self.assertTrue(set(before) <= set(self.path.vertices))

    def test_an_edge_of_the_path_adds_nothing(self):
        self.path.click((15, 16))
        self.assertFalse(self.path.click((16, 15)))
        self.assertEqual(self.path.vertices, [15, 16])

    def test_ctrl_click_keeps_the_longer_part(self):
        self.path.click((14, 15))
        self.path.click((20, 21))
        self.assertTrue(self.path.remove((16, 15)))
        self.assertEqual(self.path.vertices, [16, 17, 18, 19, 20, 21])
        self.assertFalse(self.path.remove((15, 16)))

    def test_the_last_edge_goes_too(self):
        self.path.click((14, 15))
        self.assertTrue(self.path.remove((14, 15)))
        self.assertEqual((self.path.vertices, self.path.length, self.path.edge_count), ([], 0.0, 0))

    def test_take_back(self):
        self.path.click((14, 15))
        self.path.click((20, 21))
        self.path.take_back()
        self.assertEqual(self.path.vertices, [14, 15])


class OnACylinder(unittest.TestCase):
    """Open, 24 points around: ring j has the ids 24·j … 24·j + 23."""

    def setUp(self):
        self.path = PickPath(SurfaceLines(*surfaces.cylinder()))

    def test_the_whole_line_of_a_rim_is_closed(self):
        self.path.take_line((3, 4))
        self.assertTrue(self.path.closed)
        self.assertEqual(set(self.path.vertices), set(range(24)))

    def test_removing_an_edge_opens_it_there(self):
        self.path.take_line((3, 4))
        self.path.remove((4, 5))
        self.assertFalse(self.path.closed)
        self.assertEqual(len(self.path.vertices), 24)
        self.assertEqual({self.path.vertices[0], self.path.vertices[-1]}, {4, 5})

    def test_clicks_can_close_it(self):
        for edge in ((120, 121), (128, 129), (136, 137), (140, 141), (142, 143), (143, 120)):
            self.assertFalse(self.path.closed)
            self.path.click(edge)
        self.assertTrue(self.path.closed)
        self.assertEqual(set(self.path.vertices), set(range(120, 144)))
        self.assertFalse(self.path.click((100, 101)), "a closed path does not grow")


class OnTheWing(unittest.TestCase):
    def setUp(self):
        points, triangles, self.leading_edge = surfaces.wing()
        self.path = PickPath(SurfaceLines(points, triangles))

    def test_two_clicks_follow_the_leading_edge(self):
        ids = self.leading_edge
        self.path.click(tuple(ids[5:7]))
        self.path.click(tuple(ids[80:82]))
        self.assertEqual(self.path.vertices, ids[5:82])

    def test_lines_that_meet_are_joined(self):
        ids = self.leading_edge
        self.path.click(tuple(ids[5:7]))
        self.path.take_line(tuple(ids[40:42]))
        self.assertEqual(set(self.path.vertices), set(ids))


if __name__ == "__main__":
    unittest.main()
