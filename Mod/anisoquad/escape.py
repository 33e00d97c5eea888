"""Esc stops what a recompute does on the GUI's thread."""

import time
from contextlib import contextmanager

import FreeCADGui
from PySide import QtCore

from .compat import qt_widgets, translate
from .stages import stage_title

_POLL = 0.05  # seconds between two looks at what the user did

_INPUT = tuple(getattr(QtCore.QEvent, name) for name in (
    "KeyPress", "KeyRelease", "ShortcutOverride", "Shortcut", "MouseButtonPress", "MouseButtonRelease", "MouseButtonDblClick", "Wheel",
    "ContextMenu", "TouchBegin", "Drop", "Close"))


class EscapeFilter(QtCore.QObject):
    """Notes Esc, and keeps all other input from a document that is being recomputed."""

    def __init__(self):
        super().__init__()
        self.pressed = False

    def eventFilter(self, _, event):
        if event.type() not in _INPUT:
            return False
        if event.type() in (QtCore.QEvent.KeyPress, QtCore.QEvent.ShortcutOverride) and event.key() == QtCore.Qt.Key_Escape:
            self.pressed = True
        return True


@contextmanager
def stoppable():
    """Gives the progress(stage, fraction) of a run on the GUI's thread: the window draws itself, and Esc ends the run; None elsewhere."""
    application = qt_widgets().QApplication.instance()
    if application is None or QtCore.QThread.currentThread() != application.thread():
        yield None
        return
    escape, last = EscapeFilter(), [time.monotonic()]
    bar = FreeCADGui.getMainWindow().statusBar()

    def progress(stage, fraction):
        if time.monotonic() - last[0] >= _POLL:
            bar.showMessage(translate("Stages", "{stage} {percent} % – Esc stops it").format(
                stage=translate("Stages", stage_title(stage)), percent=round(100 * fraction)))
            application.processEvents()
            last[0] = time.monotonic()
        return not escape.pressed

    application.installEventFilter(escape)
    try:
        yield progress
    finally:
        application.removeEventFilter(escape)
        bar.clearMessage()
