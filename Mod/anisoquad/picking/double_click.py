"""Double clicks in the 3D view: Coin's events do not tell them from two clicks, Qt's do."""

from PySide import QtCore


class DoubleClick(QtCore.QObject):
    """Watches a view's mouse events before Coin gets them.

    pending -- True from the second press of a double click until taken
    """

    def __init__(self, view):
        super().__init__()
        self.pending = False
        self._viewport = view.graphicsView().viewport()
        self._viewport.installEventFilter(self)

    def eventFilter(self, _, event):
        if event.type() == QtCore.QEvent.MouseButtonDblClick:
            self.pending = True
        elif event.type() == QtCore.QEvent.MouseButtonPress:
            self.pending = False
        return False

    def take(self):
        """True when the press that is being handled is the second of a double click."""
        pending, self.pending = self.pending, False
        return pending

    def stop(self):
        self._viewport.removeEventFilter(self)
