"""From edges of a CAD shape to the mesh edges that lie on them."""

import numpy as np

from ..errors import MeshError

_TOLERANCE = 1e-4  # of the mesh's diagonal; tessellations put their points on the curves


def vertices_on_edges(points, triangles, edges):
    """The path of mesh points along Part edges that follow each other.

    points -- (N,3) float64, triangles -- (M,3) int32, edges -- Part.Edge objects in any order and direction
    Returns point ids, closed when the first is also the last. Raises MeshError ("invalid_source") where the mesh does not
    follow the edges, or where they are not one line.
    """
    import Part

    tolerance = _TOLERANCE * np.linalg.norm(np.ptp(points, axis=0))
    chains = Part.sortEdges(edges)
    if len(chains) != 1:
        raise MeshError("The chosen edges are not one line.", code="invalid_source")
    path = []
    for edge in chains[0]:
        path = _joined(path, _along(edge, points, tolerance))
    _check(path, triangles)
    return path


def _joined(path, ids):
    """The path with what follows it, turned round where only that makes the ends meet."""
    if not path or not ids:
        return path or ids
    if path[-1] not in (ids[0], ids[-1]) and path[0] in (ids[0], ids[-1]):
        path = path[::-1]
    if path[-1] == ids[-1]:
        ids = ids[::-1]
    return path + ids[path[-1] == ids[0] :]


def _along(edge, points, tolerance):
    """Ids of the points on an edge, one way or the other."""
    box = edge.BoundBox
    low = np.array([box.XMin, box.YMin, box.ZMin]) - tolerance
    high = np.array([box.XMax, box.YMax, box.ZMax]) + tolerance
    near = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1))
    found = []
    for index in near.tolist():
        place = _place(edge, points[index], tolerance)
        if place is not None:
            found.append((place, index))
    found.sort()
    ids = [index for _, index in found]
    if edge.isClosed() and ids:
        ids.append(ids[0])
    return ids


def _place(edge, point, tolerance):
    """The curve's parameter at a point, or None when the point is not on the edge."""
    import FreeCAD

    point = FreeCAD.Vector(*point)
    try:
        place = edge.Curve.parameter(point)
    except Exception:  # OpenCASCADE finds no closest point
        return None
    first, last = edge.ParameterRange
    place = min(max(place, first), last)
    return place if edge.Curve.value(place).distanceToPoint(point) <= tolerance else None


def _check(path, triangles):
    if len(path) < 2:
        raise MeshError("No mesh edges lie on the chosen edges.", code="invalid_source")
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]).astype(np.int64), axis=1)
    size = int(triangles.max()) + 1
    pairs = np.sort(np.column_stack([path[:-1], path[1:]]).astype(np.int64), axis=1)
    apart = ~np.isin(pairs @ [size, 1], sides @ [size, 1])
    if apart.any():
        raise MeshError("The mesh does not follow the chosen edges.", code="invalid_source", kind="edge",
                        ids=pairs[apart].ravel().tolist())
