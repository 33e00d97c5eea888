"""Triangulated surfaces for the tests: (points, triangles), outward or upward oriented."""

import json
import os
from pathlib import Path

import numpy as np

from anisoquad.io import read_triangles

DATA = Path(__file__).resolve().parents[1] / "data"


def plane(columns=12, lines=10):
    """A rectangle of unit cells; its lower edge is points 0 … columns."""
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(lines + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return points, _split(_cells(columns, lines, columns + 1))


def cylinder(columns=24, lines=10):
    """An open cylinder of radius 1 around z."""
    angle, z = np.meshgrid(np.arange(columns) * 2 * np.pi / columns, np.arange(lines + 1) * 2 * np.pi / columns)
    points = np.column_stack([np.cos(angle).ravel(), np.sin(angle).ravel(), z.ravel()])
    return points, _split(_cells(columns, lines, columns))


def torus(columns=36, lines=16):
    """A torus of radii 1 and 0.4."""
    u, v = np.meshgrid(np.arange(columns) * 2 * np.pi / columns, np.arange(lines) * 2 * np.pi / lines)
    radius = 1 + 0.4 * np.cos(v)
    points = np.column_stack([(radius * np.cos(u)).ravel(), (radius * np.sin(u)).ravel(), (0.4 * np.sin(v)).ravel()])
    return points, _split(_cells(columns, lines, columns) % (columns * lines))


def cube(cells=6):
    """The surface of a cube of side 1."""
    grid, triangles = plane(cells, cells)
    grid = grid / cells - [0.5, 0.5, 0.0]
    faces = []
    for axis in range(3):
        for side in (1, -1):
            face = np.empty_like(grid)
            face[:, axis] = 0.5 * side
            face[:, (axis + 1) % 3], face[:, (axis + 2) % 3] = grid[:, 0], side * grid[:, 1]
            faces.append(face)
    points, index = np.unique(np.round(np.concatenate(faces), 9), axis=0, return_inverse=True)
    index = index.reshape(6, -1)
    return points, np.concatenate([index[face][triangles] for face in range(6)])


def sphere(cells=8):
    """A unit sphere, blown up from a cube."""
    points, triangles = cube(cells)
    return points / np.linalg.norm(points, axis=1, keepdims=True), triangles


def wing(name="wing_delta"):
    """(points, triangles, ids of the leading edge) of a wing of tests/data."""
    points, triangles = read_triangles(DATA / f"{name}.off")
    return points, triangles, json.loads((DATA / f"{name}.json").read_text())["leading_edge"]


def shared_folder():
    """The folder of surfaces that others made, or None: ANISOQUAD_SHARED, or ../shared beside the repository."""
    folder = Path(os.environ.get("ANISOQUAD_SHARED", DATA.parents[2] / "shared"))
    return folder if folder.is_dir() else None


def _cells(columns, lines, stride):
    """(columns·lines, 4) corners; the last column joins the first one where the stride equals columns."""
    i, j = (index.ravel() for index in np.meshgrid(np.arange(columns), np.arange(lines)))
    right = (i + 1) % stride
    return np.column_stack([j * stride + i, j * stride + right, (j + 1) * stride + right, (j + 1) * stride + i])


def _split(cells):
    """Triangles of the cells, with alternating diagonals."""
    odd = (np.arange(len(cells)) % 2).astype(bool)
    first = np.where(odd[:, None], cells[:, [0, 1, 2]], cells[:, [0, 1, 3]])
    second = np.where(odd[:, None], cells[:, [0, 2, 3]], cells[:, [1, 2, 3]])
    return np.concatenate([first, second])
