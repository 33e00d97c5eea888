"""A QuadMesh made by hand: two unit quads side by side, the left one in a row along x = 0."""

import numpy as np

from anisoquad import QuadMesh


def two_quads():
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0.1]], float)
    return QuadMesh(
        points=points,
        quads=np.array([[0, 1, 2, 3], [1, 4, 5, 2]], np.int32),
        row=np.array([1, 0], np.int32),
        pass_=np.array([1, 0], np.int32),
        source=np.array([0, -1], np.int32),
        patch=np.array([0, 1], np.int32),
        node_line=np.array([0, -1, -1, 0, -1, -1], np.int32),
        node_input=np.full(6, -1, np.int32),
        line_edges=np.array([[0, 3, 0], [4, 5, 1]], np.int32),
        report={"triangles_left": 0, "inverted": 0},
    )
