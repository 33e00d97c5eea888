"""The triangles of a Part shape in a document."""

import FreeCAD

from . import properties

SCHEMA_VERSION = 1

_DEFLECTION = 2e-4  # of the shape's diagonal; coarser ones leave too little of thin noses and small fillets to remesh


class TrianglesObject(properties.SavedByProperties):
    """Proxy of a Mesh::FeaturePython that keeps a tessellation of its Shape, made by MeshPart."""

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)
        self._attach_view(obj)

    def add_properties(self, obj):
        """Add what is missing."""
        properties.add(obj, "App::PropertyLink", "Shape", "Triangles", "The Part object")
        properties.add(obj, "App::PropertyLength", "Deflection", "Triangles", "Largest distance of the triangles from the shape; 0: a five-thousandth of its diagonal")
        properties.add(obj, "App::PropertyLength", "MaxLength", "Triangles",
                       "Largest edge of well-shaped triangles (Mefisto) instead; 0: as large as deflection and angle allow")
        if properties.add(obj, "App::PropertyAngle", "Angle", "Triangles", "Largest angle between the normals of neighbours"):
            obj.Angle = 8.0
        if properties.add(obj, "App::PropertyInteger", "SchemaVersion", "Internal", "Version of these properties", True):
            obj.SchemaVersion = SCHEMA_VERSION
        properties.hide(obj, "SchemaVersion")

    def execute(self, obj):
        """Tessellate. Raises MeshError when there is no shape."""
        import MeshPart

        from .shape_link import shape_of

        shape = shape_of(obj.Shape)
        if obj.MaxLength.Value > 0.0:
            obj.Mesh = MeshPart.meshFromShape(Shape=shape, MaxLength=obj.MaxLength.Value)
            return
        deflection = obj.Deflection.Value or _DEFLECTION * shape.BoundBox.DiagonalLength
        obj.Mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection,
                                          AngularDeflection=obj.Angle.getValueAs("rad").Value, Relative=False)

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        self._attach_view(obj)

    @staticmethod
    def _attach_view(obj):
        if FreeCAD.GuiUp:
            from ..viewproviders.triangles_view_provider import attach

            attach(obj)


def is_triangles(obj):
    """True for the tessellation of a Part object."""
    return properties.is_kind(obj, TrianglesObject)


def is_triangles_of(obj, shape):
    """True for the tessellation of this Part object."""
    return is_triangles(obj) and obj.Shape is shape


def triangles_of(shape):
    """The tessellation of a Part object in its document, or None."""
    return next((obj for obj in shape.InList if is_triangles_of(obj, shape)), None)
