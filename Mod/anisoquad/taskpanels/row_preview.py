"""Draws where rows will come, before meshing."""

from .. import _core
from ..objects.mesh_job import MeshJob
from ..viewproviders.line_node import LineNode

_COLOURS = ((0.91, 0.35, 0.25), (0.96, 0.68, 0.22), (0.48, 0.74, 0.35), (0.25, 0.62, 0.80))  # one a pass, as in pictures


class RowPreview:
    """Lines over the model, one colour a pass."""

    def __init__(self, view):
        self._scene = view.getSceneGraph()
        self._nodes = [LineNode(colour, 1) for colour in _COLOURS]
        for node in self._nodes:
            self._scene.addChild(node.root)

    def show(self, obj):
        """Draw the rows of a quad mesh object as its properties are now. Raises MeshError."""
        job = MeshJob.of(obj)
        points, triangles, sources = job.straightened()
        ends, pass_ = _core.preview_rows(points, triangles, [source.to_core() for source in sources], job.options)
        for index, node in enumerate(self._nodes):
            chosen = ends.reshape(-1, 2, 3)[(pass_ - 1) % len(_COLOURS) == index]
            node.show([[tuple(a), tuple(b)] for a, b in chosen.tolist()])

    def clear(self):
        for node in self._nodes:
            node.clear()

    def remove(self):
        """Take it out of the view. May be called again."""
        for node in self._nodes:
            if self._scene.findChild(node.root) >= 0:
                self._scene.removeChild(node.root)
