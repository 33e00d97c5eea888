"""What the benchmark scripts share: the wings of tests/data, and measures of their rows."""

import json
from pathlib import Path

import numpy as np

from anisoquad.io import read_triangles

DATA = Path(__file__).resolve().parents[1] / "data"


def read(name):
    """(points, triangles, ids of the leading edge)."""
    points, triangles = read_triangles(DATA / f"{name}.off")
    return points, triangles, json.loads((DATA / f"{name}.json").read_text())["leading_edge"]


def aspect_ratios(mesh):
    """(Q,) longer over shorter of the two mean lengths of opposite edges."""
    corners = mesh.points[mesh.quads]
    length = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    first, second = length[:, ::2].mean(axis=1), length[:, 1::2].mean(axis=1)
    return np.maximum(first, second) / np.minimum(first, second)


def position_along(mesh, start, end):
    """(Q,) where each quad's centre stands along a straight line: 0 at its start, 1 at its end."""
    line = end - start
    return (mesh.points[mesh.quads].mean(axis=1) - start) @ line / (line @ line)
