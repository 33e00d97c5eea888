"""The quad mesh in a document."""

import FreeCAD
import numpy as np

from .. import convert
from ..errors import MeshError
from ..second_order import SecondOrder
from ..translation import QT_TRANSLATE_NOOP
from . import properties
from .base_mesh import base_signature
from .mesh_job import MeshJob
from .mesh_run import MeshRun
from .option_properties import add_options
from .recompute_run import run_in_recompute, told_briefly
from .report_properties import add_report, show_report
from .stored_result import unpack
from .undo_observer import observe

SCHEMA_VERSION = 2

_KEPT_RUNS = 3  # runs that undo and redo find again


class QuadMeshObject(properties.SavedByProperties):
    """Proxy of a Fem::FemMeshObjectPython that keeps an all-quad mesh of its Base.

    error -- the MeshError of the last execute(), or None
    """

    def __init__(self, obj):
        obj.Proxy = self
        self._restart()
        self.add_properties(obj)
        self._attach_view(obj)

    def _restart(self):
        self.error = None
        self._runs = []
        observe()

    def add_properties(self, obj):
        """Add what is missing, so that objects of older files get the newer properties with their defaults."""
        properties.add(obj, "App::PropertyLink", "Base", "QuadMesh", QT_TRANSLATE_NOOP("App::Property", "The triangle mesh"))
        properties.add(obj, "App::PropertyLinkList", "Sources", "QuadMesh", QT_TRANSLATE_NOOP("App::Property", "Lines along which anisotropic rows are built"))
        if properties.add(obj, "App::PropertyEnumeration", "ElementOrder", "QuadMesh", QT_TRANSLATE_NOOP("App::Property", "1st: four nodes a quad; 2nd: eight")):
            obj.ElementOrder = ["1st", "2nd"]
        if properties.add(obj, "App::PropertyBool", "OntoShape", "QuadMesh",
                          QT_TRANSLATE_NOOP("App::Property", "Where the base is the tessellation of a Part object: patches are its faces, and nodes lie exactly on it")):
            obj.OntoShape = True
        properties.add(obj, "App::PropertyAngle", "SmoothAngle", "QuadMesh",
                       QT_TRANSLATE_NOOP("App::Property", "Faces of the Part object whose normals differ by less where they meet are one patch; 0: each is one"))
        properties.add(obj, "App::PropertyLink", "Part", "QuadMesh", QT_TRANSLATE_NOOP("App::Property", "The Part object on which the mesh lies, where FEM looks for it"), True)
        add_options(obj)
        add_report(obj)
        properties.add(obj, "App::PropertyString", "BaseSignature", "Internal", QT_TRANSLATE_NOOP("App::Property", "The base mesh of the last run"), True)
        properties.add(obj, "App::PropertyString", "QuadData", "Internal", QT_TRANSLATE_NOOP("App::Property", "Row, pass, source, patch of the quads; lines"), True)
        if properties.add(obj, "App::PropertyInteger", "SchemaVersion", "Internal", properties.VERSION_DOC, True):
            obj.SchemaVersion = SCHEMA_VERSION
        # Node coordinates are those of the world, and a placement would be applied twice after reload.
        properties.hide(obj, "BaseSignature", "QuadData", "SchemaVersion", "Placement")

    @told_briefly
    def execute(self, obj):
        """Mesh the base. On an error, and when Esc stops it, the old mesh stays, and the object's status says what is wrong."""
        try:
            job = MeshJob.of(obj)
            run = self.find(job.key) or run_in_recompute(job)
        except Exception as error:
            self.error = error
            raise
        self.error = None
        self.keep(run)
        obj.FemMesh = run.take_fem_mesh(job)
        part = obj.Base.Shape if job.shape is not None else None
        if obj.Part is not part:
            obj.Part = part
        obj.BaseSignature = base_signature(obj.Base)
        obj.QuadData = run.packed
        show_report(obj, run.mesh.report)

    def keep(self, run):
        """Take over a MeshRun that was made elsewhere: the next execute() with the same input uses it."""
        self._runs = [other for other in self._runs if other.key != run.key][-_KEPT_RUNS + 1 :] + [run]

    def remember(self, obj):
        """Take over the run that the object holds, from a file or from before, so that undo and cancel find it again."""
        if obj.Quads == 0 or "Touched" in obj.State or self.find(MeshJob.of(obj).key):
            return
        self.keep(MeshRun(result_of(obj), second_order_of(obj), MeshJob.of(obj).key))

    def knows_run(self, obj):
        """True when execute() would find its result without meshing."""
        try:
            return obj.Quads > 0 and self.find(MeshJob.of(obj).key) is not None
        except MeshError:
            return False

    def run_of(self, data):
        """The run of this session that is kept as this QuadData, or None; see result_of()."""
        return next((run for run in reversed(self._runs) if run.packed == data), None)

    def find(self, key):
        """The run of the job with this key, or None where it is not known any more."""
        return next((run for run in self._runs if run.key == key), None)

    def mustExecute(self, obj):
        """FreeCAD does not touch what depends on a mesh when the mesh is assigned: compare."""
        if "BaseSignature" not in obj.PropertiesList or obj.Base is None or not obj.Base.isDerivedFrom("Mesh::Feature"):
            return False
        return obj.BaseSignature != base_signature(obj.Base)

    def onDocumentRestored(self, obj):
        self._restart()
        self.add_properties(obj)
        self._attach_view(obj)

    @staticmethod
    def _attach_view(obj):
        if FreeCAD.GuiUp:
            from ..viewproviders.quad_mesh_view_provider import attach

            attach(obj)


def is_quad_mesh(obj):
    return properties.is_kind(obj, QuadMeshObject)


def result_of(obj):
    """The QuadMesh of a quad mesh object, of this session's run or of the saved file; None when there is none yet."""
    if not obj.QuadData:
        return None
    run = obj.Proxy.run_of(obj.QuadData)
    if run is not None:
        return run.mesh
    points, quads = convert.fem_mesh_to_arrays(obj.FemMesh)
    if quads.shape[1] == 8:  # the mid-side nodes follow the corners
        quads = np.ascontiguousarray(quads[:, :4])
        points = points[: quads.max() + 1]
    return unpack(obj.QuadData, points, quads, obj.Report)


def second_order_of(obj):
    """The SecondOrder of a quad mesh object; None when its quads have four nodes."""
    fem_mesh = obj.FemMesh
    if fem_mesh.FaceCount == 0 or len(fem_mesh.getElementNodes(1)) != 8:
        return None
    return SecondOrder(*convert.fem_mesh_to_arrays(fem_mesh))
