"""The five steps of the user's guide and a CAD shape, done in the window; the pictures are those of docs/guide.md."""

import sys
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from window import ROOT, SCREENSHOTS, WindowTest, wait

import anisoquad
from anisoquad.compat import qt_widgets
from anisoquad.gmsh import has_gmsh

sys.path.append(str(ROOT / "tests" / "freecad"))

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
        self.base.ViewObject.DisplayMode = "Flat Lines"
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

    def test_then_a_cad_shape(self):
        from shapes import leading_edge, loft_wing

        self.doc.removeObject(self.base.Name)
        wing = loft_wing(self.doc)
        self.quads = anisoquad.make_quad_mesh(self.doc, base=wing, sources=[leading_edge(wing)], anisotropy=16, smooth_angle=5.0,
                                              triangulator="Gmsh" if has_gmsh() else None, options=anisoquad.Options(size=40.0))
        self.doc.recompute()
        for obj in (wing, self.doc.WingRoot, self.doc.WingTip, self.quads.Base):
            obj.ViewObject.Visibility = False
        turned = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), -50) * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 60)
        self.view.setCameraOrientation(turned.Q)
        self.view.fitAll()
        FreeCADGui.ActiveDocument.setEdit(self.quads.Name)
        wait(seconds=0.3)
        self.assertTrue(self.panel("QuadMeshPanel").findChild(object, "ontoShape").isChecked())
        self.picture("guide_6_cad_shape")
        self.button("Cancel").click()

    def picture(self, name):
        self.screenshot(name)
        path = str(SCREENSHOTS / f"{name}.png")
        image = QtGui.QImage(path).scaledToWidth(WIDTH, QtCore.Qt.SmoothTransformation)
        few_colours = image.convertToFormat(QtGui.QImage.Format_RGB666)  # smaller files
        self.assertTrue(few_colours.convertToFormat(QtGui.QImage.Format_RGB888).save(path, "PNG", 0))
