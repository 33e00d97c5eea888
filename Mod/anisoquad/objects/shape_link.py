"""The CAD shape of a Part object, for meshing onto it."""

import zlib

from ..cad import CadShape, CadSurface, has_cad
from ..compat import global_placement
from ..errors import MeshError
from .triangles_object import is_triangles


class ShapeLink:
    """A shape as text, apart from the document: what a run in another thread needs of it."""

    def __init__(self, brep, name, smooth_angle=0.0):
        self.brep, self.name, self.smooth_angle = brep, name, smooth_angle

    def __repr__(self):
        """Differs when the shape does."""
        return f"ShapeLink({len(self.brep)}, {zlib.crc32(self.brep.encode()):08x}, {self.smooth_angle!r})"

    def surface(self, points, triangles):
        """The CadSurface of triangles of this shape. Raises MeshError when they do not belong together, or the shape is invalid."""
        return CadSurface(CadShape.from_brep(self.brep, self.name), points, triangles, join_smooth=self.smooth_angle)


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


def link_to(obj, smooth_angle=0.0):
    """The ShapeLink of a Part object."""
    return ShapeLink(shape_of(obj).exportBrepToString(), obj.Label, smooth_angle)


def shape_behind(base, smooth_angle=0.0):
    """The ShapeLink of the Part object of which the base is the tessellation; None for other meshes, and without OpenCASCADE."""
    return link_to(base.Shape, smooth_angle) if is_triangles(base) and has_cad() else None
