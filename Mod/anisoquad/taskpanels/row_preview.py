"""Draws where rows will come, before meshing."""

from ..viewproviders.line_node import LineNode

_COLOURS = ((0.91, 0.35, 0.25), (0.96, 0.68, 0.22), (0.48, 0.74, 0.35), (0.25, 0.62, 0.80))  # one a pass, as in pictures


class RowPreview:
    """Lines over the model, one colour a pass."""

    def __init__(self, view):
        self._scene = view.getSceneGraph()
        self._nodes = [LineNode(colour, 1) for colour in _COLOURS]
        for node in self._nodes:
            self._scene.addChild(node.root)

    def show(self, ends, pass_):
        """Draw edges (E,2,3) of rows that are built by these passes (E,), 1-based."""
        for index, node in enumerate(self._nodes):
            node.show_segments(ends[(pass_ - 1) % len(_COLOURS) == index])

    def clear(self):
        for node in self._nodes:
            node.clear()

    def remove(self):
        """Take it out of the view. May be called again."""
        for node in self._nodes:
            if self._scene.findChild(node.root) >= 0:
                self._scene.removeChild(node.root)
