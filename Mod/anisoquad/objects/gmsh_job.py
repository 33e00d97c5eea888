"""One run of Gmsh on a Part object's shape, apart from the document: run anywhere, also off the GUI's thread."""

import zlib

from .. import convert
from ..gmsh import SMALLEST, triangulate_brep
from .shape_link import shape_of


class GmshJob:
    """The input of a run, as a triangles object has it."""

    def __init__(self, brep, diagonal, size, angle):
        self.brep, self.diagonal, self.size, self.angle = brep, diagonal, size, angle

    @classmethod
    def of(cls, obj):
        """The job of a triangles object. Raises MeshError when it has no shape."""
        shape = shape_of(obj.Shape)
        return cls(shape.exportBrepToString(), shape.BoundBox.DiagonalLength, obj.Size.Value, obj.CurvatureAngle.Value)

    @property
    def key(self):
        """Text that differs when anything that the result depends on does."""
        return f"{len(self.brep)} {zlib.crc32(self.brep.encode()):08x} {self.size!r} {self.angle!r}"

    def run(self, progress=None):
        """The Mesh.Mesh. Raises MeshError, and Cancelled when progress(stage, fraction) returned False."""
        points, triangles = triangulate_brep(self.brep, size=self.size, angle=self.angle, smallest=SMALLEST * self.diagonal, progress=progress)
        return convert.mesh_of(points, triangles)
