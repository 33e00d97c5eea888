"""The numpy façade of the core."""

import numpy as np

from . import _core
from .errors import MeshError
from .quad_mesh_result import QuadMesh
from .source import Source

Options = _core.Options

_INT32 = np.iinfo(np.int32)


def quad_mesh(points, triangles, sources=(), options=None, progress=None, surface=None):
    """Mesh a triangulated surface with quadrilaterals, with anisotropic rows along the sources.

    points    -- (N,3) numbers, any unit
    triangles -- (M,3) 0-based indices, manifold and consistently oriented
    sources   -- Source objects, or lists of vertex ids (such a line is a feature without rows)
    options   -- Options
    progress  -- callable(stage: str, fraction: float); returning False cancels
    surface   -- anisoquad.cad.CadSurface of these points and triangles: patches are those of its faces, nodes are put onto it
    Returns a QuadMesh. Raises MeshError with the ids of what is wrong in the input, Cancelled when progress said so.
    """
    options = options if options is not None else Options()
    take_invalid = surface is not None and options.repair
    if surface is not None:
        points = surface.points
        options = with_feature_edges(options, surface.feature_edges)
        options.repair = False  # they were checked when they were linked to the shape
    sources = [source if isinstance(source, Source) else Source(source) for source in sources]
    result = _core.quad_mesh(
        checked_points(points),
        checked_triangles(triangles),
        [source.to_core() for source in sources],
        options,
        progress,
        surface.core if surface is not None else None,
    )
    if surface is not None:
        result.update(surface.entities_of(result))
        if take_invalid and (invalid := surface.shape.invalid_faces()):
            result["report"]["warnings"].append(f"invalid faces of the shape were taken as they are: {', '.join(invalid)}")
        if result["report"]["inverted"] and (folds := surface.count_folds()):
            result["report"]["warnings"].append(f"the shape's triangles are folded over at {folds} edges; let Gmsh make them")
    return QuadMesh(**result)


def with_feature_edges(options, edges):
    """A copy of the options with further feature edges, as pairs of point ids."""
    copy = Options(**{name: getattr(options, name) for name in Options.fields})
    copy.feature_edges = [*options.feature_edges, *edges]
    return copy


def checked_points(points):
    """(N,3) float64, C-contiguous. Raises MeshError."""
    try:
        array = np.ascontiguousarray(points, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise MeshError(f"The points are not an array of numbers: {error}") from None
    if array.size == 0:
        return np.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"The points must have shape (N, 3), not {array.shape}.")
    return array


def checked_triangles(triangles):
    """(M,3) int32, C-contiguous. Raises MeshError."""
    try:
        array = np.asarray(triangles)
    except ValueError as error:
        raise MeshError(f"The triangles are not an array of indices: {error}") from None
    if array.size == 0:
        return np.empty((0, 3), np.int32)
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"The triangles must have shape (M, 3), not {array.shape}.")
    if array.dtype.kind not in "iu":
        raise MeshError(f"The triangles must be whole numbers, not {array.dtype}.")
    # What int32 can't hold is out of range at its limits too, so that the core names the facets.
    return np.ascontiguousarray(np.clip(array, _INT32.min, _INT32.max), dtype=np.int32)
