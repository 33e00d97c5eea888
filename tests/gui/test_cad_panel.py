"""The quad mesh panel's fields for a CAD shape: onto shape, smooth angle, triangulator; its stages in the user's language."""

import json
import subprocess
import unittest
from unittest import mock

import FreeCADGui
import Part
from PySide import QtCore
from window import WindowTest, wait

import anisoquad
from anisoquad.compat import qt_widgets, translate
from anisoquad.gmsh import has_gmsh
from anisoquad.stages import TITLES


class TubeTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.tube = self.doc.addObject("Part::Cylinder", "Tube")
        self.tube.Radius, self.tube.Height = 10.0, 30.0
        self.doc.recompute()

    def make(self, part=None, **keywords):
        """A quad mesh of the tube or another Part object, one step of undo of its own."""
        self.doc.openTransaction("make")
        quads = anisoquad.make_quad_mesh(self.doc, base=part or self.tube, options=anisoquad.Options(size=4.0), **keywords)
        self.doc.recompute()
        self.doc.commitTransaction()
        wait(seconds=0.1)
        return quads

    def open(self, obj):
        FreeCADGui.ActiveDocument.setEdit(obj.Name)
        wait(seconds=0.1)
        return self.panel("QuadMeshPanel")

    def apply(self, form):
        self.button("Apply").click()
        self.assertTrue(wait(lambda: form.findChild(object, "cancel").isEnabled(), 20))
        self.assertTrue(wait(lambda: self.is_done(form), 60))
        wait(seconds=0.1)

    @staticmethod
    def is_done(form):
        """No worker runs."""
        return not form.findChild(object, "cancel").isEnabled()

    def field(self, form, name):
        return form.findChild(object, name)


class CadPanel(TubeTest):
    def test_every_field_tells_what_it_is(self):
        form = self.open(self.make())
        for name in ("triangulator", "ontoShape", "smoothAngle"):
            self.assertGreater(len(self.field(form, name).toolTip()), 30, name)
            self.assertGreater(len(self.field(form, name).whatsThis()), 100, name)
        self.button("Cancel").click()

    def test_they_are_off_but_for_a_part_shape(self):
        form = self.open(self.make_quad_mesh())
        self.assertFalse(self.field(form, "cadBox").isVisible())
        for name in ("triangulator", "ontoShape", "smoothAngle"):
            self.assertFalse(self.field(form, name).isEnabled(), name)
        self.button("Cancel").click()
        wait()
        quads = self.make()
        form = self.open(quads)
        self.assertTrue(self.field(form, "cadBox").isVisible())
        for name in ("triangulator", "ontoShape", "smoothAngle"):
            self.assertTrue(self.field(form, name).isEnabled(), name)
        self.field(form, "ontoShape").setChecked(False)
        self.assertFalse(self.field(form, "smoothAngle").isEnabled())
        box = self.field(form, "base")
        box.setCurrentIndex(box.findText(self.base.Label))
        self.assertFalse(self.field(form, "ontoShape").isEnabled())
        box.setCurrentIndex(box.findText(quads.Base.Label))
        self.assertTrue(self.field(form, "ontoShape").isEnabled())
        self.button("Cancel").click()

    def test_smooth_angle_joins_faces_and_cancel_parts_them(self):
        box = Part.makeBox(20.0, 20.0, 10.0)
        rounded = self.doc.addObject("Part::Feature", "Rounded")
        rounded.Shape = box.makeFillet(4.0, box.Edges[:1])
        quads = self.make(rounded)
        before = json.loads(quads.Report)["patches"]
        self.assertEqual(before, 7)
        form = self.open(quads)
        self.assertTrue(self.field(form, "ontoShape").isChecked())
        self.field(form, "smoothAngle").setValue(5.0)
        self.apply(form)
        self.assertEqual((quads.SmoothAngle.Value, json.loads(quads.Report)["patches"]), (5.0, 5))
        self.assertLess(quads.Reduction, 0.0)
        self.assertNotIn("fewer elements", self.field(form, "figures").text())
        self.button("Cancel").click()
        wait()
        self.assertEqual((quads.SmoothAngle.Value, json.loads(quads.Report)["patches"]), (0.0, before))

    def test_onto_shape(self):
        quads = self.make()
        self.assertIs(quads.Part, self.tube)
        form = self.open(quads)
        self.field(form, "ontoShape").setChecked(False)
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 60))
        self.assertFalse(quads.OntoShape)
        self.assertIsNone(quads.Part)
        self.doc.undo()
        self.assertTrue(quads.OntoShape)

    @unittest.skipUnless(has_gmsh(), "Gmsh is not installed")
    def test_gmsh_is_chosen_with_the_options_size_and_undone(self):
        quads = self.make()
        before = quads.Base.Mesh.CountFacets
        form = self.open(quads)
        self.field(form, "triangulator").setCurrentText("Gmsh")
        self.field(form, "Size").setValue(3.0)
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 60))
        self.assertEqual((quads.Base.Triangulator, quads.Base.Size.Value, quads.Base.CurvatureAngle.Value), ("Gmsh", 3.0, 30.0))
        self.assertEqual((quads.getStatusString(), quads.Base.getStatusString()), ("Valid", "Valid"))
        self.assertEqual(quads.TrianglesIn, quads.Base.Mesh.CountFacets)
        self.assertNotEqual(quads.Base.Mesh.CountFacets, before)
        self.doc.undo()
        wait()
        self.assertEqual((quads.Base.Triangulator, quads.Base.Mesh.CountFacets, quads.TrianglesIn), ("OpenCASCADE", before, before))

    @unittest.skipUnless(has_gmsh(), "Gmsh is not installed")
    def test_stop_ends_gmsh_and_the_window_stays_alive(self):
        quads = self.make(triangulator="Gmsh")
        before = quads.Base.Mesh.CountFacets, quads.Quads
        form = self.open(quads)
        self.field(form, "Size").setValue(0.02)
        started, start = [], subprocess.Popen

        def note(*arguments, **keywords):
            started.append(start(*arguments, **keywords))
            return started[-1]

        with mock.patch.object(subprocess, "Popen", note):
            self.button("Apply").click()
            self.assertTrue(wait(lambda: started and TITLES["triangulate"] in self.field(form, "progress").format(), 20))
            self.assertFalse(wait(lambda: self.is_done(form), 1.0), "too short a run to stop")
            self.screenshot("gmsh_runs")
            self.field(form, "cancel").click()
            self.assertTrue(wait(lambda: self.is_done(form), 10))
        self.assertLess(started[0].returncode, 0, "killed by a signal")
        self.assertIn("Stopped", self.field(form, "figures").text())
        self.assertEqual(self.field(form, "progress").format(), "%p %")
        self.assertEqual((quads.Base.Mesh.CountFacets, quads.Quads), before)
        self.button("Cancel").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 10))
        self.assertEqual((quads.Base.Size.Value, quads.Base.Mesh.CountFacets, quads.Quads), (4.0, *before))

    @unittest.skipUnless(has_gmsh(), "Gmsh is not installed")
    def test_escape_ends_gmsh_in_a_recompute_without_a_panel(self):
        quads = self.make(triangulator="Gmsh")
        before = quads.Base.Mesh.CountFacets, quads.Quads
        started, start, pressed = [], subprocess.Popen, []

        def note(*arguments, **keywords):
            started.append(start(*arguments, **keywords))
            return started[-1]

        def press():
            pressed.append(started[0].poll())
            self.screenshot("gmsh_recompute")
            self.click((0, 0, 0))  # other input is not for a document that is being recomputed
            self.key(QtCore.Qt.Key_Escape)

        self.select()
        quads.Base.Size = 0.02
        with mock.patch.object(subprocess, "Popen", note):
            QtCore.QTimer.singleShot(1000, press)
            self.doc.recompute()
        self.assertEqual(pressed, [None], "Gmsh ran when Esc was pressed")
        self.assertLess(started[0].returncode, 0, "killed by a signal")
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        self.assertIn("cancelled", quads.Base.getStatusString())
        self.assertEqual((quads.Base.Mesh.CountFacets, quads.Quads, quads.FemMesh.FaceCount), (*before, before[1]))
        quads.Base.Size = 4.0
        self.doc.recompute()
        self.assertEqual((quads.Base.getStatusString(), quads.getStatusString()), ("Valid", "Valid"))
        self.assertEqual((quads.Base.Mesh.CountFacets, quads.Quads), before)

    def test_without_gmsh_the_panel_names_the_package(self):
        quads = self.make()
        form = self.open(quads)
        self.field(form, "triangulator").setCurrentText("Gmsh")
        with mock.patch("shutil.which", return_value=None):
            self.apply(form)
        self.assertIn("apt-get install gmsh", self.field(form, "figures").text())
        self.assertGreater(quads.Quads, 0)
        self.button("Cancel").click()
        wait()
        self.assertEqual((quads.Base.Triangulator, quads.getStatusString()), ("OpenCASCADE", "Valid"))


class Languages(TubeTest):
    def test_a_german_panel_shows_german_stages(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale("German")
        wait(seconds=0.1)
        german = {translate("Stages", title) for title in TITLES.values()}
        self.assertIn("Glätten", german)
        self.assertEqual(german & set(TITLES.values()), set())
        form = self.open(self.make())
        self.assertEqual(form.findChild(object, "cad").labelForField(self.field(form, "smoothAngle")).text(), "Glatt bis")
        shown, progress = set(), self.field(form, "progress")
        progress.valueChanged.connect(lambda *_: shown.add(progress.format().split(" %p")[0]))
        self.field(form, "Size").setValue(0.7)
        self.button("Anwenden").click()
        self.assertTrue(wait(lambda: not self.is_done(form), 20))
        self.assertTrue(wait(lambda: self.is_done(form), 60))
        self.assertTrue(shown & german, shown)
        self.assertEqual(shown - german - {"", "%p %", "%p%"}, set())
        self.screenshot("german_cad")
        self.button("Abbrechen").click()

    def test_the_property_editor_has_german_tooltips(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale("German")
        quads = self.make()
        self.select(quads)
        wait(seconds=0.5)
        tips = set()
        for view in FreeCADGui.getMainWindow().findChildren(qt_widgets().QTreeView):
            if view.metaObject().className() == "Gui::PropertyEditor::PropertyEditor":
                tips.update(tip.split("\n")[-1] for tip in texts(view.model(), QtCore.QModelIndex()) if tip)
        for text in ("Zahl der Vierecke", "Linien, an denen anisotrope Reihen entstehen", "Grenze der Durchgänge der letzten Glättung"):
            self.assertIn(text, tips)


def texts(model, parent):
    """All tooltips of an item model below an index."""
    for row in range(model.rowCount(parent)):
        index = model.index(row, 0, parent)
        yield model.data(index, QtCore.Qt.ToolTipRole)
        yield from texts(model, index)
