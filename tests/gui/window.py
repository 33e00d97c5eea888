"""What the tests do in the window: wait, move the mouse, press keys, take pictures."""

import json
import os
import tempfile
import time
import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
from PySide import QtCore, QtGui

from anisoquad.compat import qt_widgets

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "tests" / "data"
SCREENSHOTS = ROOT / "build" / "screenshots"


def wait(condition=lambda: False, seconds=0.2):
    """Let the window work until the condition holds. Returns whether it did."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        qt_widgets().QApplication.processEvents()
        if condition():
            return True
        time.sleep(0.005)
    return condition()


class WindowTest(unittest.TestCase):
    """Has a document with a wing, seen from above, that is closed at the end."""

    WING = "wing_delta"

    def setUp(self):
        FreeCADGui.activateWorkbench("AnisoQuadWorkbench")
        self.doc = FreeCAD.newDocument("GuiTest")
        self.doc.UndoMode = 1
        self.addCleanup(self.close)
        self.base = self.doc.addObject("Mesh::Feature", "Wing")
        self.base.Mesh = Mesh.Mesh(str(DATA / f"{self.WING}.off"))
        self.doc.recompute()
        self.leading_edge = json.loads((DATA / f"{self.WING}.json").read_text())["leading_edge"]
        self.view = FreeCADGui.ActiveDocument.ActiveView
        self.view.setAnimationEnabled(False)
        window = FreeCADGui.getMainWindow()
        docks = [dock for dock in window.findChildren(qt_widgets().QDockWidget) if dock.objectName() == "Combo View"]
        window.resizeDocks(docks, [400] * len(docks), QtCore.Qt.Horizontal)
        self.view.viewTop()
        self.view.fitAll()
        wait()

    def close(self):
        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        wait()

    def select(self, *objects):
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(obj)
        wait(seconds=0.05)

    def run_command(self, name):
        FreeCADGui.runCommand(name)
        wait(seconds=0.1)

    def panel(self, name):
        """The widget of the open task panel."""
        widget = FreeCADGui.getMainWindow().findChild(qt_widgets().QWidget, name)
        self.assertIsNotNone(widget, f"no panel {name}")
        return widget

    def button(self, text):
        """A standard button of the task panel."""
        for button in FreeCADGui.getMainWindow().findChildren(qt_widgets().QPushButton):
            if button.text().replace("&", "") == text and button.isVisible():
                return button
        raise AssertionError(f"no button {text}")

    def place(self, point):
        """(x, y) of a point of space in the view's widget."""
        x, y = self.view.getPointOnScreen(FreeCAD.Vector(*point))
        viewport = self.view.graphicsView().viewport()
        ratio = viewport.devicePixelRatioF()
        return QtCore.QPoint(round(x / ratio), round(viewport.height() - 1 - y / ratio))

    def mouse(self, kind, place, button=QtCore.Qt.LeftButton, modifiers=QtCore.Qt.NoModifier):
        viewport = self.view.graphicsView().viewport()
        pressed = QtCore.Qt.NoButton if kind in (QtCore.QEvent.MouseMove, QtCore.QEvent.MouseButtonRelease) else button
        event = QtGui.QMouseEvent(kind, QtCore.QPointF(place), QtCore.QPointF(viewport.mapToGlobal(place)),
                                  QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else button, pressed, modifiers)
        qt_widgets().QApplication.sendEvent(viewport, event)
        wait(seconds=0.02)

    def hover(self, point):
        self.mouse(QtCore.QEvent.MouseMove, self.place(point))

    def click(self, point, modifiers=QtCore.Qt.NoModifier, times=1):
        place = self.place(point)
        self.mouse(QtCore.QEvent.MouseMove, place, modifiers=modifiers)
        for time_ in range(times):
            kind = QtCore.QEvent.MouseButtonDblClick if time_ else QtCore.QEvent.MouseButtonPress
            self.mouse(kind, place, modifiers=modifiers)
            self.mouse(QtCore.QEvent.MouseButtonRelease, place, modifiers=modifiers)

    def key(self, key):
        viewport = self.view.graphicsView().viewport()
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            qt_widgets().QApplication.sendEvent(viewport, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier))
        wait(seconds=0.05)

    def screenshot(self, name):
        """A picture of the whole window."""
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        wait(seconds=0.1)
        window = FreeCADGui.getMainWindow()
        picture = window.windowHandle().screen().grabWindow(window.winId())
        self.assertTrue(picture.save(str(SCREENSHOTS / f"{name}.png")))

    def pixels_like(self, colour, tolerance=40):
        """How many of the view's pixels have nearly this colour (three numbers up to 255)."""
        wait(seconds=0.1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "view.png")
            self.view.saveImage(path, 600, 400, "Current")
            image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGB888)
        lines = np.frombuffer(bytes(image.constBits()), np.uint8).reshape(image.height(), image.bytesPerLine())
        pixels = lines[:, : 3 * image.width()].reshape(-1, 3).astype(int)
        return int((np.abs(pixels - colour).max(axis=1) <= tolerance).sum())

    def make_quad_mesh(self, **keywords):
        """A quad mesh of the wing with its leading edge as source, meshed without a panel; one step of undo of its own."""
        import anisoquad

        self.doc.openTransaction("make")
        obj = anisoquad.make_quad_mesh(self.doc, base=self.base, **{"sources": [self.leading_edge], "anisotropy": 4, **keywords})
        self.doc.recompute()
        self.doc.commitTransaction()
        wait(seconds=0.1)
        return obj

    def wait_for_mesh(self, form):
        """Until the panel's worker is done."""
        stop, progress = form.findChild(object, "cancel"), form.findChild(object, "progress")
        self.assertTrue(wait(lambda: stop.isEnabled() or progress.value() == progress.maximum(), 5), "meshing did not start")
        self.assertTrue(wait(lambda: not stop.isEnabled(), 60), "meshing did not end")
        wait(seconds=0.1)

    def middle(self, a, b):
        """The middle of two points of the base mesh."""
        points = self.base.Mesh.Points
        return (points[a].Vector + points[b].Vector) * 0.5
