"""The CAD shape of a Part object, for meshing onto it."""

import zlib

from ..cad import CadShape, CadSurface, has_cad
from ..compat import global_placement
from ..errors import MeshError
from .triangles_object import is_triangles, tessellation_of


_last = {}  # key of a ShapeLink: its CadShape with triangles, which the objects of one recompute share


class ShapeLink:
    """A shape as text, apart from the document: what a run in another thread needs of it.

    tessellation -- (deflection, degrees) by which OpenCASCADE makes its triangles; None where others made them
    """

    def __init__(self, brep, name, smooth_angle=0.0, tessellation=None):
        self.brep, self.name, self.smooth_angle, self.tessellation = brep, name, smooth_angle, tessellation

    def __repr__(self):
        """Differs when the shape does."""
        return f"ShapeLink({len(self.brep)}, {zlib.crc32(self.brep.encode()):08x}, {self.smooth_angle!r})"

    def surface(self, points, triangles, check=True):
        """The CadSurface of triangles of this shape. Raises MeshError when they do not belong together.

        check -- reject a shape with faces in which OpenCASCADE finds errors, too
        """
        shape = self._triangulated() if self.tessellation else CadShape.from_brep(self.brep, self.name, check=False)
        if check:
            shape.check()
        return CadSurface(shape, points, triangles, join_smooth=self.smooth_angle)

    def triangles(self):
        """(points (N,3), triangles (M,3)) by its tessellation. Raises MeshError ("face_not_meshable") with faces that get none."""
        made = self._triangulated().made
        return made.points, made.triangles

    def _triangulated(self):
        key = (self.brep, self.name, self.tessellation)
        shape = _last.get(key)
        if shape is None:
            shape = CadShape.from_brep(self.brep, self.name, check=False)
            shape.triangulate(*self.tessellation)
            _last.clear()  # another thread may have put its own there
            _last[key] = shape
        return shape


def shape_of(obj):
    """The Part.Shape of a document object in the world, without the triangles that are kept in it for views.

    Raises MeshError ("invalid_shape") when there is none.
    """
    if obj is None or not hasattr(obj, "Shape") or obj.Shape.isNull():
        raise MeshError(f"{obj.Label + ': it' if obj is not None else 'Shape: no Part object is chosen, or it'} has no shape.", code="invalid_shape")
    if not obj.Shape.Faces:
        raise MeshError(f"{obj.Label}: the shape has no faces.", code="invalid_shape")
    shape = obj.Shape.copy(False, False)
    shape.Placement = global_placement(obj)
    return shape


def link_to(obj, smooth_angle=0.0, tessellation=None):
    """The ShapeLink of a Part object."""
    return ShapeLink(shape_of(obj).exportBrepToString(), obj.Label, smooth_angle, tessellation)


def shape_behind(base, smooth_angle=0.0):
    """The ShapeLink of the Part object of which the base is the tessellation; None for other meshes, and without OpenCASCADE."""
    return link_to(base.Shape, smooth_angle, tessellation_of(base)) if is_triangles(base) and has_cad() else None
