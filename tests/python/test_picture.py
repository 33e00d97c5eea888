"""The z-buffer: what is in front hides what is behind."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from anisoquad.picture import render, row_colours, save_png

RED, BLUE = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


def two_squares(first_z, second_z):
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
    points = np.concatenate([np.column_stack([square, np.full(4, z)]) for z in (first_z, second_z)])
    return points, np.array([[0, 1, 2, 3], [4, 5, 6, -1]]), np.array([RED, BLUE])


class Render(unittest.TestCase):
    def view(self, *mesh, towards=(0, 0, 1)):
        return render(*mesh, towards, (0, 1, 0), (0, 0, 0), 4.0, (80, 60))

    def test_the_nearer_face_is_seen(self):
        lower_right = (38, 50)  # inside the square, and inside the triangle's half of it
        for second_z, seen in ((-1.0, 0), (1.0, 2)):
            image = self.view(*two_squares(0.0, second_z))
            self.assertEqual(int(image[lower_right].argmax()), seen)

    def test_outside_is_white_and_size_is_kept(self):
        image = self.view(*two_squares(0.0, 1.0))
        self.assertEqual(image.shape, (60, 80, 3))
        self.assertEqual(image[2, 2].tolist(), [255, 255, 255])

    def test_up_is_up(self):
        points = np.array([[-0.5, 0.2, 0], [0.5, 0.2, 0], [0.5, 1.2, 0], [-0.5, 1.2, 0]])
        image = self.view(points, np.array([[0, 1, 2, 3]]), np.array([RED]))
        self.assertTrue((image[30:] == 255).all())
        self.assertFalse((image[:30] == 255).all())

    def test_rows_have_colours_of_their_pass(self):
        colours = row_colours([0, 1, 2, 1], [0, 1, 1, 2])
        self.assertEqual(len(np.unique(colours, axis=0)), 4)

    def test_png(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.png"
            image = self.view(*two_squares(0.0, 1.0))
            save_png(path, image)
            from matplotlib.image import imread

            self.assertTrue(np.array_equal(np.round(imread(path)[..., :3] * 255).astype(np.uint8), image))
