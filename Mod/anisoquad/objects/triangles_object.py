"""The triangles of a Part shape in a document."""

import FreeCAD

from .. import convert
from ..cad import has_cad
from ..errors import MeshError
from ..translation import QT_TRANSLATE_NOOP
from . import properties
from .recompute_run import run_in_recompute, told_briefly

SCHEMA_VERSION = 2

TRIANGULATORS = ("OpenCASCADE", "Gmsh")

_DEFLECTION = 2e-4  # of the shape's diagonal; coarser ones leave too little of thin noses and small fillets to remesh
_KEPT_RUNS = 3  # of Gmsh, that undo and redo find again

_INPUTS = (
    ("Shape", "App::PropertyLink", QT_TRANSLATE_NOOP("App::Property", "The Part object")),
    ("Triangulator", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "OpenCASCADE: as few triangles as Deflection and Angle allow; Gmsh: triangles of good shape, by Size and Curvature Angle")),
    ("Deflection", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Largest distance of OpenCASCADE's triangles from the shape; 0: a five-thousandth of its diagonal")),
    ("MaxLength", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Largest edge of well-shaped triangles by OpenCASCADE (Mefisto) instead; 0: as large as deflection and angle allow")),
    ("Angle", "App::PropertyAngle", QT_TRANSLATE_NOOP("App::Property", "Largest angle between the normals of neighbours, by OpenCASCADE")),
    ("Size", "App::PropertyLength", QT_TRANSLATE_NOOP("App::Property", "Largest edge of Gmsh's triangles; 0: a tenth of the shape's diagonal")),
    ("CurvatureAngle", "App::PropertyAngle", QT_TRANSLATE_NOOP(
        "App::Property", "Degrees that one edge of Gmsh's triangles may turn along the surface; 0: any")),
)
_DEFAULTS = {"Triangulator": list(TRIANGULATORS), "Angle": 8.0, "CurvatureAngle": 30.0}


class TrianglesObject(properties.SavedByProperties):
    """Proxy of a Mesh::FeaturePython that keeps a tessellation of its Shape, made by OpenCASCADE or by Gmsh."""

    def __init__(self, obj):
        obj.Proxy = self
        self._runs = {}
        self.add_properties(obj)
        self._attach_view(obj)

    def add_properties(self, obj):
        """Add what is missing, so that objects of older files get the newer properties with their defaults."""
        for name, type_, doc in _INPUTS:
            if properties.add(obj, type_, name, "Triangles", doc) and name in _DEFAULTS:
                setattr(obj, name, _DEFAULTS[name])
        if properties.add(obj, "App::PropertyInteger", "SchemaVersion", "Internal", properties.VERSION_DOC, True):
            obj.SchemaVersion = SCHEMA_VERSION
        properties.hide(obj, "SchemaVersion")

    @told_briefly
    def execute(self, obj):
        """Tessellate. Raises MeshError when there is no shape, and when Gmsh is missing, fails, or is stopped by Esc; the old mesh stays then."""
        if obj.Triangulator == "Gmsh":
            job = self.gmsh_job(obj)
            mesh = self._runs[job.key] if job.key in self._runs else run_in_recompute(job)
            self.keep(job, mesh)
            obj.Mesh = mesh
        else:
            obj.Mesh = _by_opencascade(obj)

    def gmsh_job(self, obj):
        """The GmshJob of the object; MeshError as execute()."""
        from .gmsh_job import GmshJob

        return GmshJob.of(obj)

    def missing_run(self, obj):
        """The GmshJob that execute() would have to run now; None where it needs none, as with OpenCASCADE."""
        if obj.Triangulator != "Gmsh" or not ("Touched" in obj.State or "Invalid" in obj.State or obj.Mesh.CountFacets == 0):
            return None
        job = self.gmsh_job(obj)
        return None if job.key in self._runs else job

    def keep(self, job, mesh):
        """Take over the mesh of a GmshJob that was run elsewhere: the next execute() with the same input uses it."""
        self._runs.pop(job.key, None)
        self._runs[job.key] = mesh
        for key in list(self._runs)[:-_KEPT_RUNS]:
            del self._runs[key]

    def onDocumentRestored(self, obj):
        self._runs = {}
        self.add_properties(obj)
        self._attach_view(obj)

    @staticmethod
    def _attach_view(obj):
        if FreeCAD.GuiUp:
            from ..viewproviders.triangles_view_provider import attach

            attach(obj)


def tessellation_of(obj):
    """(deflection, degrees) by which OpenCASCADE makes the object's triangles; None where it does not, or by Mefisto."""
    if obj.Triangulator != "OpenCASCADE" or obj.MaxLength.Value > 0.0:
        return None
    return obj.Deflection.Value, obj.Angle.getValueAs("deg").Value


def _by_opencascade(obj):
    """The Mesh.Mesh by the mesher's own part for CAD; by MeshPart where that is missing, by Mefisto, and with faces left out."""
    from .shape_link import link_to, shape_of

    tessellation = tessellation_of(obj)
    if tessellation and has_cad():
        try:
            return convert.mesh_of(*link_to(obj.Shape, tessellation=tessellation).triangles())
        except MeshError as error:
            if error.code != "face_not_meshable":
                raise
    import MeshPart

    shape = shape_of(obj.Shape)
    if obj.MaxLength.Value > 0.0:
        return MeshPart.meshFromShape(Shape=shape, MaxLength=obj.MaxLength.Value)
    deflection = obj.Deflection.Value or _DEFLECTION * shape.BoundBox.DiagonalLength
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=obj.Angle.getValueAs("rad").Value, Relative=False)


def is_triangles(obj):
    """True for the tessellation of a Part object."""
    return properties.is_kind(obj, TrianglesObject)


def is_triangles_of(obj, shape):
    """True for the tessellation of this Part object."""
    return is_triangles(obj) and obj.Shape is shape


def triangles_of(shape):
    """The tessellation of a Part object in its document, or None."""
    return next((obj for obj in shape.InList if is_triangles_of(obj, shape)), None)
