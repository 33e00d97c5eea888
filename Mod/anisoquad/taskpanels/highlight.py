"""Shows in the view which elements of the triangles an error names."""

import numpy as np

from ..objects.base_mesh import base_arrays
from ..viewproviders.line_node import LineNode

_COLOUR = (1.0, 0.2, 0.0)


class Highlight:
    """Marks vertices, edges or facets over the model."""

    def __init__(self, view):
        self._scene = view.getSceneGraph()
        self._node = LineNode(_COLOUR, 6)
        self._scene.addChild(self._node.root)

    def show(self, error, base):
        """Mark what a MeshError names, on the mesh object that it is about; nothing where it names nothing."""
        if error.kind not in ("vertex", "edge", "facet") or base is None:
            self.clear()
            return
        points, triangles = base_arrays(base)
        ids = np.array(error.ids, int)
        limit = len(triangles) if error.kind == "facet" else len(points)
        ids = ids[(ids >= 0) & (ids < limit)]
        place = points.tolist()
        if error.kind == "vertex":
            self._node.show([], points=[tuple(place[v]) for v in ids])
        elif error.kind == "edge":
            pairs = ids[: len(ids) // 2 * 2].reshape(-1, 2)
            self._node.show([[tuple(place[v]) for v in pair] for pair in pairs])
        else:
            corners = [[tuple(place[v]) for v in triangles[f]] for f in ids]
            self._node.show([[*facet, facet[0]] for facet in corners], facets=corners)

    def show_line(self, points):
        """Mark a line of points."""
        self._node.show([[tuple(point) for point in points]] if points else [])

    def clear(self):
        self._node.clear()

    def remove(self):
        """Take it out of the view. May be called again."""
        if self._scene.findChild(self._node.root) >= 0:
            self._scene.removeChild(self._node.root)
