"""Named sets."""

import unittest

import numpy as np
from small_mesh import two_quads

from anisoquad.groups import face_groups, line_groups


class Groups(unittest.TestCase):
    def test_patches_passes_and_lines(self):
        mesh = two_quads()
        faces = {name: ids.tolist() for name, ids in face_groups(mesh).items()}
        self.assertEqual(faces, {"Patch_1": [0], "Patch_2": [1], "Source_1_Pass_1": [0]})
        lines = {name: edges.tolist() for name, edges in line_groups(mesh).items()}
        self.assertEqual(lines, {"Line_1": [[0, 3]], "Line_2": [[4, 5]]})

    def test_no_rows_give_no_row_groups(self):
        mesh = two_quads()
        mesh.row[:] = 0
        self.assertFalse(any(name.startswith("Source") for name in face_groups(mesh)))
        self.assertEqual(sum(len(ids) for ids in face_groups(mesh).values()), 2)
        self.assertEqual(np.concatenate(list(line_groups(mesh).values())).shape, (2, 2))
