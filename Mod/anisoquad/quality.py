"""Measures of quads, for files and pictures. The figures of a run are in its report, made by the core."""

import numpy as np


def scaled_jacobian(points, quads):
    """(Q,) scaled Jacobian of each quad, as Verdict defines it: 1 for a rectangle, not above 0 when inverted."""
    corners = np.asarray(points)[quads]
    edges = np.roll(corners, -1, axis=1) - corners
    previous = np.roll(edges, 1, axis=1)
    normal = np.cross(corners[:, 2] - corners[:, 0] + corners[:, 1] - corners[:, 3],
                      corners[:, 2] - corners[:, 0] - corners[:, 1] + corners[:, 3])
    normal = _unit(normal)
    area = np.einsum("qck,qk->qc", np.cross(_unit(previous), _unit(edges)), normal)
    return area.min(axis=1)


def _unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, 1.0)
