"""Measures of quads, for files, pictures and panels. The figures of a run are in its report, made by the core."""

import numpy as np


def scaled_jacobian(points, quads):
    """(Q,) scaled Jacobian of each quad, as Verdict defines it: 1 for a rectangle, not above 0 when inverted."""
    edges = _edges(points, quads)
    previous = np.roll(edges, 1, axis=1)
    first, second = _axes(edges)
    normal = _unit(np.cross(first, second))
    area = np.einsum("qck,qk->qc", np.cross(_unit(previous), _unit(edges)), normal)
    return area.min(axis=1)


def aspect_ratio(points, quads):
    """(Q,) longest over shortest edge, 1…∞."""
    length = np.linalg.norm(_edges(points, quads), axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        return length.max(axis=1) / length.min(axis=1)


def skew(points, quads):
    """(Q,) cosine of the angle between the two principal axes, 0 (rectangle) … 1."""
    first, second = _axes(_edges(points, quads))
    return np.abs(np.einsum("qk,qk->q", _unit(first), _unit(second)))


def size(points, quads):
    """(Q,) side of the square of the same area, in the unit of the points."""
    corners = np.asarray(points)[quads]
    return np.sqrt(0.5 * np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1))


def _edges(points, quads):
    """(Q,4,3): edge k leaves corner k."""
    corners = np.asarray(points)[quads]
    return np.roll(corners, -1, axis=1) - corners


def _axes(edges):
    return edges[:, 0] - edges[:, 2], edges[:, 1] - edges[:, 3]


def _unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, 1.0)
