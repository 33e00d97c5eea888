"""What a run of the mesher gives, and the forms in which a document keeps it."""

from functools import cached_property

from .. import convert
from .stored_result import pack


class MeshRun:
    """The quad mesh, its second-order form (None for first order), and the key of the job that made it."""

    def __init__(self, mesh, second_order, key):
        self.mesh = mesh
        self.second_order = second_order
        self.key = key
        self._fem_mesh = None

    @cached_property
    def packed(self):
        """What a FemMesh can not keep of the mesh, as text."""
        return pack(self.mesh)

    def prepare(self, job):
        """Make for the document what takes long; may be done on any thread."""
        self._fem_mesh = self._make_fem_mesh(job)
        self.packed  # noqa: B018

    def take_fem_mesh(self, job):
        """The Fem.FemMesh; handed out once, since it takes much memory, and made anew for who asks again."""
        fem_mesh, self._fem_mesh = self._fem_mesh, None
        return self._make_fem_mesh(job) if fem_mesh is None else fem_mesh

    def _make_fem_mesh(self, job):
        nodes = convert.source_nodes(self.mesh, job.sources, job.points)
        return convert.fem_mesh_of(self.mesh, self.second_order, nodes)
