"""Lines on a triangulated surface: picked, suggested, straightened. No FreeCAD."""

from dataclasses import dataclass

import numpy as np

from . import _core
from .meshing import Options, checked_points, checked_triangles


@dataclass(frozen=True)
class EdgeHit:
    """The mesh edge that a ray points at.

    facet -- index of the triangle that it meets first, -1 when it passes beside the surface
    point -- (3,) where it meets the triangle, else where it passes the edge
    edge  -- (from, to): the edge's ends
    """

    facet: int
    point: np.ndarray
    edge: tuple


class SurfaceLines:
    """The lines of a triangulated surface of N points and M triangles.

    Raises MeshError when the triangles can not be meshed either.
    """

    def __init__(self, points, triangles, feature_angle=None, feature_edges=()):
        """points (N,3), triangles (M,3); feature_angle (degrees) and feature_edges (pairs of ids) as in Options."""
        angle = Options().feature_angle if feature_angle is None else feature_angle
        self.points = checked_points(points)
        self._surface = _core.PickSurface(self.points, checked_triangles(triangles), angle, [tuple(edge) for edge in feature_edges])

    def edge_on_ray(self, origin, direction, reach=0.0):
        """The EdgeHit of a ray, or None. Feature lines, and edges beside the outline, count up to `reach` from the ray."""
        hit = self._surface.edge_on_ray(_vector(origin), _vector(direction), reach)
        return None if hit is None else EdgeHit(hit[0], np.array(hit[1]), hit[2])

    def best_path(self, start, end):
        """Vertex ids of the path between two vertices that follows ridges and feature lines; empty when there is none."""
        return self._surface.best_path(start, end)

    def whole_line(self, edge):
        """Vertex ids of the feature line or ridge through an edge (from, to), up to its corners."""
        return self._surface.whole_line(*edge)

    def suggest(self):
        """Lines (vertex ids) that look like leading and trailing edges, the longest first."""
        return self._surface.suggest_lines()

    def is_zigzag(self, path):
        """True when a path turns left and right in turn, so that imprint() has something to straighten."""
        return self._surface.is_zigzag(list(path))

    def length(self, path):
        """Length of a path of vertex ids, in the unit of the points."""
        return float(np.linalg.norm(np.diff(self.points[list(path)], axis=0), axis=1).sum())

    def imprint(self, path):
        """(points, triangles, path) with the zigzags of a path straightened into the triangles.

        The input points keep their ids, new ones follow; feature edges are kept.
        """
        points, triangles, straight, _ = self._surface.imprint(list(path))
        return points, triangles, straight

    def onto_surface(self, points, on_line):
        """(P,3) points brought onto the surface, or onto its feature lines where on_line (P,) is true."""
        return self._surface.onto_surface(np.ascontiguousarray(points, float), np.asarray(on_line, bool))


def imprint(points, triangles, path, keep=(), feature_angle=None):
    """(points, triangles, path) with the zigzags of a path straightened into the triangles.

    keep -- other paths of vertex ids, whose edges stay
    """
    return SurfaceLines(points, triangles, feature_angle, edges_of(keep)).imprint(path)


def cut_at_ends(paths):
    """Paths of vertex ids, each cut where another one ends on it: lines that are sources together may only meet where both end.

    A closed path (its first vertex is its last) on which an end lies becomes open pieces, two at least.
    """
    ends = {path[end] for path in paths if path[0] != path[-1] for end in (0, -1)}
    pieces = []
    for path in paths:
        path = list(path)
        if path[0] == path[-1]:
            start = next((i for i, vertex in enumerate(path) if vertex in ends), 0)
            path = path[start:-1] + path[: start + 1]
        cuts = [0, *(i for i in range(1, len(path) - 1) if path[i] in ends), len(path) - 1]
        if path[0] == path[-1] and path[0] in ends and len(cuts) == 2:
            cuts.insert(1, len(path) // 2)
        pieces += [path[first : last + 1] for first, last in zip(cuts[:-1], cuts[1:])]
    return pieces


def edges_of(paths):
    """[(from, to), …] of paths of vertex ids."""
    return [edge for path in paths for edge in zip(path[:-1], path[1:])]


def _vector(values):
    x, y, z = values
    return float(x), float(y), float(z)
