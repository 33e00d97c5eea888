"""Triangles of facets with more corners. No FreeCAD."""

import numpy as np


def split_polygons(points, facets):
    """(triangles (M,3) int64, number of facets that were split). Triangles of one facet follow each other in its place.

    points -- (N,3) numbers
    facets -- lists of point ids; what has three corners, or fewer, or an id that is no point stays as it is
    Raises ValueError for a facet with fewer than three corners.
    """
    triangles, split = [], 0
    for facet in facets:
        if len(facet) < 3:
            raise ValueError(f"a facet with {len(facet)} corners")
        if len(facet) == 3 or min(facet) < 0 or max(facet) >= len(points):
            triangles += [facet[:1] + facet[k : k + 2] for k in range(1, len(facet) - 1)]
        else:
            triangles += _cut_ears(points, list(facet))
        split += len(facet) > 3
    return np.array(triangles, np.int64).reshape(-1, 3), split


def _cut_ears(points, ids):
    """Corner after corner is cut off, the one with the shortest cut first, of those that lie within the polygon."""
    corners = points[ids]
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    triangles = []
    while len(ids) > 3:
        ears = [(np.linalg.norm(points[ids[k - 1]] - points[ids[(k + 1) % len(ids)]]), k)
                for k in range(len(ids)) if _is_ear(points, ids, k, normal)]
        k = min(ears)[1] if ears else 0
        triangles.append([ids[k - 1], ids[k], ids[(k + 1) % len(ids)]])
        del ids[k]
    return [*triangles, ids]


def _is_ear(points, ids, k, normal):
    """The corner is convex, and no other one lies in its triangle."""
    a, b, c = (points[ids[i % len(ids)]] for i in (k - 1, k, k + 1))
    if np.cross(b - a, c - a) @ normal <= 0.0:
        return False
    others = points[[id_ for i, id_ in enumerate(ids) if (i - k + 1) % len(ids) > 2]]
    inside = [np.cross(q - p, others - p) @ normal >= 0.0 for p, q in ((a, b), (b, c), (c, a))]
    return not np.any(inside[0] & inside[1] & inside[2])
