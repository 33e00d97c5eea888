"""The quad mesh in a document."""

import json
from itertools import chain

import FreeCAD

from .. import convert
from ..compat import global_placement
from ..errors import MeshError
from ..meshing import Options, quad_mesh
from .source_text import from_text

SCHEMA_VERSION = 1

# Options that are for tests and pictures, not for documents.
_NOT_PROPERTIES = ("validate", "record_stages")

_INPUTS = (
    ("Base", "App::PropertyLink", "The triangle mesh"),
    ("Sources", "App::PropertyStringList", "Line sources of anisotropy: point ids of the base mesh, one line of JSON each"),
    ("Passes", "App::PropertyString", "Merge ratio of each pass, with rows or not: 4:6, 2, 2"),
    ("Anisotropy", "App::PropertyInteger", "Maximum anisotropy, used where no passes are given"),
)

# (property, type, where it stands in the report, documentation)
_RESULTS = (
    ("Quads", "App::PropertyInteger", ("quads",), "Number of quads"),
    ("Nodes", "App::PropertyInteger", ("nodes",), "Number of nodes"),
    ("TrianglesIn", "App::PropertyInteger", ("triangles_in",), "Number of triangles of the base mesh"),
    ("Reduction", "App::PropertyFloat", ("reduction_percent",), "Percent of elements saved"),
    ("MinScaledJacobian", "App::PropertyFloat", ("scaled_jacobian", "min"), "Scaled Jacobian of the worst quad"),
    ("MeanScaledJacobian", "App::PropertyFloat", ("scaled_jacobian", "mean"), "Mean scaled Jacobian"),
    ("RegularNodes", "App::PropertyFloat", ("regular_percent",), "Percent of interior nodes with four edges"),
    ("Hausdorff", "App::PropertyFloat", ("hausdorff",), "Largest distance between the mesh and the base mesh"),
)

_PROPERTY_OF = {bool: "App::PropertyBool", int: "App::PropertyInteger", float: "App::PropertyFloat", list: "App::PropertyIntegerList"}


class QuadMeshObject:
    """Proxy of a Fem::FemMeshObjectPython that keeps an all-quad mesh of its Base.

    result -- the QuadMesh of the last run in this session, or None
    """

    def __init__(self, obj):
        obj.Proxy = self
        self.result = None
        self.add_properties(obj)
        self._attach_view(obj)

    def add_properties(self, obj):
        """Add what is missing, so that objects of older files get the newer properties with their defaults."""
        defaults = Options()
        for name, type_, doc in _INPUTS:
            self._add(obj, type_, name, "QuadMesh", doc)
        if obj.Anisotropy < 1:
            obj.Anisotropy = 1
        for field, doc in _option_fields().items():
            default = getattr(defaults, field)
            if self._add(obj, _PROPERTY_OF[type(default)], _camel(field), "Options", doc) and default:
                setattr(obj, _camel(field), default)
        for name, type_, _, doc in _RESULTS:
            self._add(obj, type_, name, "Result", doc, read_only=True)
        self._add(obj, "App::PropertyStringList", "RowsPerPass", "Result", "Rows of each pass, and why they stopped", True)
        self._add(obj, "App::PropertyStringList", "Warnings", "Result", "What the mesher warns of", True)
        self._add(obj, "App::PropertyString", "Report", "Result", "All figures of the run, as JSON", True)
        self._add(obj, "App::PropertyString", "BaseSignature", "Internal", "The base mesh of the last run", True)
        if self._add(obj, "App::PropertyInteger", "SchemaVersion", "Internal", "Version of these properties", True):
            obj.SchemaVersion = SCHEMA_VERSION
        obj.setEditorMode("BaseSignature", 2)
        obj.setEditorMode("SchemaVersion", 2)
        obj.setEditorMode("Report", 2)
        # Node coordinates are those of the world, and a placement would be applied twice after reload.
        obj.setEditorMode("Placement", 2)

    @staticmethod
    def _add(obj, type_, name, group, doc, read_only=False):
        if name in obj.PropertiesList:
            return False
        obj.addProperty(type_, name, group, doc, 1 if read_only else 0)
        return True

    def set_options(self, obj, options):
        """Keep an anisoquad.Options in the object's properties."""
        for field in _option_fields():
            value = getattr(options, field)
            setattr(obj, _camel(field), list(chain.from_iterable(value)) if isinstance(value, list) else value)

    def execute(self, obj):
        """Mesh the base. On an error the old mesh stays, and the object's status says what is wrong."""
        mesh = self._base_mesh(obj)
        placement = global_placement(obj.Base)
        sources = [from_text(text, obj.Passes, obj.Anisotropy) for text in obj.Sources]
        points, triangles = convert.mesh_to_arrays(mesh, placement)
        self.result = quad_mesh(points, triangles, sources, self._options(obj))
        obj.FemMesh = convert.fem_mesh_of(self.result)
        obj.BaseSignature = convert.signature(mesh, placement)
        self._show_report(obj, self.result.report)

    def mustExecute(self, obj):
        """FreeCAD does not touch what depends on a mesh when the mesh is assigned: compare."""
        if "BaseSignature" not in obj.PropertiesList or not _has_mesh(obj.Base):
            return False
        return obj.BaseSignature != convert.signature(obj.Base.Mesh, global_placement(obj.Base))

    def onDocumentRestored(self, obj):
        self.result = None
        self.add_properties(obj)
        self._attach_view(obj)

    @staticmethod
    def _attach_view(obj):
        if FreeCAD.GuiUp:
            from ..viewproviders.quad_mesh_view_provider import attach

            attach(obj)

    @staticmethod
    def _base_mesh(obj):
        if obj.Base is None:
            raise MeshError("Base: no triangle mesh is chosen.", code="empty_mesh")
        if not _has_mesh(obj.Base):
            raise MeshError(f"Base: {obj.Base.Label} is not a mesh.", code="empty_mesh")
        return obj.Base.Mesh

    @staticmethod
    def _options(obj):
        defaults = Options()
        values = {}
        for field in _option_fields():
            value = getattr(obj, _camel(field))
            if isinstance(getattr(defaults, field), list):
                if len(value) % 2:
                    raise MeshError(f"{_camel(field)}: point ids come in pairs.", code="invalid_feature_edge")
                value = list(zip(value[::2], value[1::2]))
            values[field] = value
        return Options(**values)

    @staticmethod
    def _show_report(obj, report):
        for name, _, path, _ in _RESULTS:
            value = report
            for key in path:
                value = value[key]
            setattr(obj, name, value)
        obj.RowsPerPass = [
            f"Source {entry['source'] + 1}, {entry['side']}, pass {entry['pass']} (1:{entry['ratio']}): "
            f"{entry['rows']} rows; {entry['stopped']}"
            for entry in report["passes"]
        ]
        obj.Warnings = report["warnings"]
        obj.Report = json.dumps(report)

    # All that has to be saved is in the properties. Older FreeCAD calls __getstate__, newer dumps.
    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def _has_mesh(base):
    return base is not None and base.isDerivedFrom("Mesh::Feature")


def _option_fields():
    return {name: doc for name, doc in Options.fields.items() if name not in _NOT_PROPERTIES}


def _camel(name):
    return "".join(part.capitalize() for part in name.split("_"))
