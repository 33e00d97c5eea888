"""A line source of anisotropy in a document."""

import FreeCAD
import numpy as np

from ..cad import has_cad
from ..errors import MeshError
from ..source import Source
from ..translation import QT_TRANSLATE_NOOP
from . import properties
from .base_mesh import base_arrays
from .part_edges import vertices_on_edges
from .recompute_run import told_briefly
from .shape_link import link_to
from .triangles_object import is_triangles_of, tessellation_of

SCHEMA_VERSION = 1

_INPUTS = (
    ("Base", "App::PropertyLink", QT_TRANSLATE_NOOP("App::Property", "The triangle mesh on which the line lies")),
    ("Vertices", "App::PropertyIntegerList", QT_TRANSLATE_NOOP("App::Property", "Point ids of the base mesh; closed when the first is also the last")),
    ("Edges", "App::PropertyLinkSub", QT_TRANSLATE_NOOP("App::Property", "Edges of a Part object instead: the mesh edges on them are the line")),
    ("Reverse", "App::PropertyBool", QT_TRANSLATE_NOOP("App::Property", "The line runs against its first edge: left and right change")),
    ("Anisotropy", "App::PropertyInteger", QT_TRANSLATE_NOOP("App::Property", "Maximum anisotropy, used where no passes are given; 1: a feature line without rows")),
    ("Passes", "App::PropertyString", QT_TRANSLATE_NOOP("App::Property", "Merge ratio of each pass, with rows or not: 4:6, 2, 2")),
    ("Sides", "App::PropertyEnumeration", QT_TRANSLATE_NOOP("App::Property", "Sides of the line, seen along it with the surface's normal up, that get rows")),
    ("Imprint", "App::PropertyBool", QT_TRANSLATE_NOOP("App::Property", "Straighten a line that zigzags over the triangles before rows start")),
)


class SourceObject(properties.SavedByProperties):
    """Proxy of an App::FeaturePython that keeps a line of mesh edges, and how anisotropic it is."""

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)
        self._attach_view(obj)

    def add_properties(self, obj):
        """Add what is missing, so that objects of older files get the newer properties with their defaults."""
        for name, type_, doc in _INPUTS:
            if properties.add(obj, type_, name, "Source", doc):
                if name == "Sides":
                    obj.Sides = ["both", "left", "right"]
                if name == "Anisotropy":
                    obj.Anisotropy = 1
        properties.add(obj, "App::PropertyLength", "Length", "Result", QT_TRANSLATE_NOOP("App::Property", "Length of the line"), True)
        properties.add(obj, "App::PropertyInteger", "EdgeCount", "Result", QT_TRANSLATE_NOOP("App::Property", "Number of mesh edges"), True)
        properties.add(obj, "App::PropertyVectorList", "Points", "Result", QT_TRANSLATE_NOOP("App::Property", "The line's points in the world"), True)
        if properties.add(obj, "App::PropertyInteger", "SchemaVersion", "Internal", properties.VERSION_DOC, True):
            obj.SchemaVersion = SCHEMA_VERSION
        properties.hide(obj, "Points", "SchemaVersion")

    @told_briefly
    def execute(self, obj):
        """Find the line on the base mesh, and measure it. Raises MeshError for ids that the mesh does not have."""
        if obj.Base is None:
            raise MeshError("Base: no triangle mesh is chosen.", code="empty_mesh")
        points, triangles = base_arrays(obj.Base)
        if obj.Edges:
            obj.Vertices = self._on_edges(obj, points, triangles)
        ids = np.array(obj.Vertices, int)
        missing = ids[(ids < 0) | (ids >= len(points))].tolist()
        if missing:
            raise MeshError(f"{obj.Label}: the mesh has no points {missing[:5]}.", code="invalid_source", kind="vertex", ids=missing)
        line = points[ids]
        obj.Length = float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
        obj.EdgeCount = max(len(line) - 1, 0)
        obj.Points = [FreeCAD.Vector(*point) for point in line.tolist()]

    @staticmethod
    def _on_edges(obj, points, triangles):
        shape, names = obj.Edges
        if is_triangles_of(obj.Base, shape) and has_cad():
            return link_to(shape, tessellation=tessellation_of(obj.Base)).surface(points, triangles, check=False).path(names, reverse=obj.Reverse)
        path = vertices_on_edges(points, triangles, [shape.getSubObject(name) for name in names])
        return path[::-1] if obj.Reverse else path

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        self._attach_view(obj)

    @staticmethod
    def _attach_view(obj):
        if FreeCAD.GuiUp:
            from ..viewproviders.source_view_provider import attach

            attach(obj)


def is_source(obj):
    return properties.is_kind(obj, SourceObject)


def source_of(obj, base):
    """The anisoquad.Source of a source object. Raises MeshError when it can not be read, or lies on another mesh."""
    if not is_source(obj):
        raise MeshError(f"Sources: {obj.Label} is not a source.", code="invalid_source")
    if obj.Base is not base:
        raise MeshError(f"Sources: {obj.Label} lies on another mesh.", code="invalid_source")
    how = {"passes": obj.Passes} if obj.Passes.strip() else {"anisotropy": obj.Anisotropy}
    return Source(obj.Vertices, sides=obj.Sides, **how)
