"""One run of the mesher, apart from the document: made of an object's properties, run anywhere, also off the GUI's thread."""

import zlib
from dataclasses import replace
from functools import cached_property

import numpy as np

from ..errors import MeshError
from ..meshing import Options, quad_mesh
from ..second_order import second_order
from ..surface_lines import imprint
from .base_mesh import base_arrays
from .mesh_run import MeshRun
from .option_properties import options_of
from .shape_link import shape_behind
from .source_object import source_of


class MeshJob:
    """The input of a run.

    points    -- (N,3) float64, triangles -- (M,3) int32: the base mesh in world coordinates
    sources   -- anisoquad.Source objects; imprinted -- for each whether it is straightened first
    shape     -- the ShapeLink of the CAD shape onto which nodes are put, or None
    """

    def __init__(self, points, triangles, sources, imprinted, options, order, shape=None):
        self.points = points
        self.triangles = triangles
        self.sources = sources
        self.imprinted = imprinted
        self.options = options
        self.order = order
        self.shape = shape

    @classmethod
    def of(cls, obj):
        """The job of a quad mesh object. Raises MeshError when its properties can not be read."""
        points, triangles = base_arrays(checked_base(obj))
        sources = [source_of(source, obj.Base) for source in obj.Sources]
        imprinted = [source.Imprint for source in obj.Sources]
        shape = shape_behind(obj.Base, obj.SmoothAngle.Value) if obj.OntoShape else None
        return cls(points, triangles, sources, imprinted, options_of(obj), 2 if obj.ElementOrder == "2nd" else 1, shape)

    @cached_property
    def key(self):
        """Text that differs when anything that the result depends on does."""
        settings = [(name, getattr(self.options, name)) for name in Options.fields]
        text = repr((self.sources, self.imprinted, settings, self.order, self.shape)).encode()
        return f"{len(self.points)} {len(self.triangles)} {zlib.crc32(self.points):08x} {zlib.crc32(self.triangles):08x} {zlib.crc32(text):08x}"

    def run(self, progress=None):
        """Mesh; returns a MeshRun. Raises MeshError, and Cancelled when progress(stage, fraction) returned False."""
        points, triangles, sources = self.straightened()
        surface = self.shape.surface(points, triangles, check=not self.options.repair) if self.shape else None
        mesh = quad_mesh(points, triangles, sources, self.options, progress, surface)
        if len(points) > len(self.points):  # what the imprint added is not a point of the user's mesh
            mesh = replace(mesh, node_input=np.where(mesh.node_input < len(self.points), mesh.node_input, -1).astype(np.int32))
        quadratic = None
        if self.order == 2:
            lines = [source.vertices for source in sources] + [list(edge) for edge in self.options.feature_edges]
            quadratic = second_order(mesh, points, triangles, self.options.feature_angle, lines, surface)
        return MeshRun(mesh, quadratic, self.key)

    def run_for_document(self, progress=None):
        """The same, and all that the document will ask of the run: for another thread than the GUI's, which it would stop."""
        run = self.run(progress)
        run.prepare(self)
        return run

    def preview(self, progress=None):
        """(ends (E,2,3), pass (E,)) of the edges of the rows that run() would build: the same without what follows the fill."""
        points, triangles, sources = self.straightened()
        options = Options(**{name: getattr(self.options, name) for name in Options.fields})
        options.cleanup, options.smoothing_passes = False, 0
        surface = self.shape.surface(points, triangles, check=not self.options.repair) if self.shape else None
        return row_edges(quad_mesh(points, triangles, sources, options, progress, surface))

    def straightened(self):
        """(points, triangles, sources) with the sources imprinted that are to be."""
        points, triangles, sources = self.points, self.triangles, list(self.sources)
        kept = [list(edge) for edge in self.options.feature_edges]
        for index, wanted in enumerate(self.imprinted):
            if wanted:
                others = [source.vertices for other, source in enumerate(sources) if other != index]
                points, triangles, path = imprint(points, triangles, sources[index].vertices, keep=others + kept,
                                                  feature_angle=self.options.feature_angle)
                sources[index] = sources[index].along(path)
        return points, triangles, sources


def row_edges(mesh):
    """(ends (E,2,3), pass (E,)) of the edges of a QuadMesh's rows."""
    in_row = mesh.row > 0
    quads, pass_ = mesh.quads[in_row], mesh.pass_[in_row]
    ends = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2).astype(np.int64), axis=1)
    _, first = np.unique(ends @ [len(mesh.points), 1], return_index=True)
    return mesh.points[ends[first]], np.repeat(pass_, 4)[first]


def checked_base(obj):
    """The mesh object that is the object's base. Raises MeshError when there is none."""
    if obj.Base is None:
        raise MeshError("Base: no triangle mesh is chosen.", code="empty_mesh")
    if not obj.Base.isDerivedFrom("Mesh::Feature"):
        raise MeshError(f"Base: {obj.Base.Label} is not a mesh.", code="empty_mesh")
    return obj.Base
