"""The five steps of the user's guide, done in the window; their pictures are those of docs/guide.md."""

import tempfile
from pathlib import Path
from unittest import mock

import FreeCADGui
from PySide import QtCore, QtGui
from window import SCREENSHOTS, WindowTest, wait

from anisoquad.compat import qt_widgets

WIDTH = 900  # pixels of the pictures in the guide


class Guide(WindowTest):
    def test_a_first_wing_in_five_steps(self):
        self.open_the_triangles()
        self.pick_the_leading_edge()
        self.mesh()
        self.look_at_the_quality()
        self.export()

    def open_the_triangles(self):
        self.view.viewIsometric()
        self.view.setCameraOrientation((0.25, -0.12, -0.2, 0.94))
        self.view.fitAll()
        self.select(self.base)
        self.picture("guide_1_triangles")

    def pick_the_leading_edge(self):
        self.run_command("AnisoQuad_AddSource")
        self.click(self.middle(*self.leading_edge[40:42]), times=2)
        self.assertEqual(self.panel("SourcePanel").findChild(object, "edges").text(), str(len(self.leading_edge) - 1))
        self.hover(self.middle(*self.leading_edge[60:62]))
        self.picture("guide_2_source")
        self.button("OK").click()
        wait()

    def mesh(self):
        self.select(self.base)
        self.run_command("AnisoQuad_QuadMesh")
        form = self.panel("QuadMeshPanel")
        self.wait_for_mesh(form)
        self.quads = self.doc.getObject("QuadMesh")
        self.assertGreater(self.quads.Quads, 0)
        wait(seconds=0.3)
        self.picture("guide_3_quad_mesh")
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 20))

    def look_at_the_quality(self):
        self.select(self.quads)
        self.run_command("AnisoQuad_Quality")
        wait(seconds=0.3)
        self.picture("guide_4_quality")
        self.button("Close").click()
        wait()

    def export(self):
        self.select(self.quads)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "wing.inp"
            with mock.patch.object(qt_widgets().QFileDialog, "getSaveFileName", return_value=(str(path), "")):
                self.run_command("AnisoQuad_Export")
            self.assertEqual(path.read_text().count("*ELEMENT, TYPE=S4"), 1)
        self.picture("guide_5_object")

    def picture(self, name):
        self.screenshot(name)
        path = str(SCREENSHOTS / f"{name}.png")
        image = QtGui.QImage(path).scaledToWidth(WIDTH, QtCore.Qt.SmoothTransformation)
        self.assertTrue(image.convertToFormat(QtGui.QImage.Format_RGB888).save(path))
