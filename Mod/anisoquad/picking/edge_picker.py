"""Mouse and keyboard in the 3D view, turned into picks of mesh edges."""

from pivy import coin

from ..viewproviders.line_node import LineNode
from .double_click import DoubleClick

_HOVER_COLOUR = (1.0, 0.8, 0.0)
_PATH_COLOUR = (0.80, 0.0, 0.0)
_REACH = 6  # pixels from the mouse within which feature lines, and edges beside the outline, are meant


class EdgePicker:
    """Lets the user pick a path on a mesh.

    Hover highlights the nearest mesh edge; a click starts the path or extends it; a double click takes the whole line;
    ctrl-click removes; Esc leaves.
    """

    def __init__(self, view, path, on_change, on_leave):
        """view -- the 3D view; path -- a PickPath; on_change(), on_leave() -- called after picks, and at Esc"""
        self._view = view
        self._path = path
        self._on_change = on_change
        self._on_leave = on_leave
        self._hover = LineNode(_HOVER_COLOUR, 6)
        self._line = LineNode(_PATH_COLOUR, 4)
        self._double_click = DoubleClick(view)
        self._hovered = None
        view.getSceneGraph().addChild(self._line.root)
        view.getSceneGraph().addChild(self._hover.root)
        self._callbacks = [
            (kind, view.addEventCallbackPivy(kind, callback))
            for kind, callback in (
                (coin.SoLocation2Event.getClassTypeId(), self._moved),
                (coin.SoMouseButtonEvent.getClassTypeId(), self._pressed),
                (coin.SoKeyboardEvent.getClassTypeId(), self._typed),
            )
        ]
        self.draw()

    def stop(self):
        """Take everything out of the view. May be called again."""
        for kind, callback in self._callbacks:
            self._view.removeEventCallbackPivy(kind, callback)
        self._callbacks = []
        self._double_click.stop()
        scene = self._view.getSceneGraph()
        for node in (self._line.root, self._hover.root):
            if scene.findChild(node) >= 0:
                scene.removeChild(node)

    def draw(self):
        """Show the path as it is."""
        self._line.show([self._coordinates(self._path.vertices)])

    def edge_at(self, position):
        """The EdgeHit under a place of the view (pixels from its lower left), or None."""
        x, y = int(position[0]), int(position[1])
        start, end = self._view.projectPointToLine((x, y))
        pixel = (self._view.getPointOnFocalPlane(x + 1, y) - self._view.getPointOnFocalPlane(x, y)).Length
        return self._path.lines.edge_on_ray(start, end - start, _REACH * pixel)

    def _coordinates(self, vertices):
        return [tuple(point) for point in self._path.lines.points[list(vertices)].tolist()]

    def _moved(self, callback):
        hit = self.edge_at(callback.getEvent().getPosition().getValue())
        edge = hit.edge if hit else None
        if edge != self._hovered:
            self._hovered = edge
            self._hover.show([self._coordinates(edge)] if edge else [])

    def _pressed(self, callback):
        event = callback.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        hit = self.edge_at(event.getPosition().getValue())
        if hit is None:
            return
        callback.setHandled()
        if event.getState() != coin.SoMouseButtonEvent.DOWN:
            return
        if event.wasCtrlDown():
            self._path.remove(hit.edge)
        elif self._double_click.take():
            self._path.take_back()  # what the first of the two presses did
            self._path.take_line(hit.edge)
        else:
            self._path.click(hit.edge)
        self.draw()
        self._on_change()

    def _typed(self, callback):
        event = callback.getEvent()
        if event.getKey() == coin.SoKeyboardEvent.ESCAPE and event.getState() == coin.SoKeyboardEvent.UP:
            callback.setHandled()
            self._on_leave()
