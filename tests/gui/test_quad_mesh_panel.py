"""The panel of a quad mesh: Apply, Cancel, errors, preview, undo and redo."""

import json
import os
import tempfile
import threading
import zlib
from types import SimpleNamespace
from unittest import mock

import FemGui
import FreeCAD
import FreeCADGui
import Mesh
import ObjectsFem
from PySide import QtCore
from window import WindowTest, wait

from anisoquad.taskpanels.figures import figures_text
from anisoquad.taskpanels.mesh_worker import MeshWorker


class QuadMeshPanel(WindowTest):
    def open(self, obj):
        FreeCADGui.ActiveDocument.setEdit(obj.Name)
        wait(seconds=0.1)
        return self.panel("QuadMeshPanel")

    def test_the_command_meshes_at_once_and_can_be_undone(self):
        self.select(self.base)
        self.run_command("AnisoQuad_QuadMesh")
        form = self.panel("QuadMeshPanel")
        self.wait_for_mesh(form)
        quads = self.doc.getObject("QuadMesh")
        self.assertEqual(quads.getStatusString(), "Valid")
        self.assertEqual(quads.FemMesh.QuadrangleCount, quads.Quads)
        self.assertIn(str(quads.Quads), form.findChild(object, "figures").text())
        self.assertFalse(self.base.ViewObject.Visibility)
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 20))
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertIsNone(self.doc.getObject("QuadMesh"))

    def test_a_run_ends_with_its_panel(self):
        """FreeCAD closes a panel without asking it, as when its document is closed."""
        polls, poll = [], MeshWorker._poll

        def note(worker):
            polls.append(worker)
            poll(worker)

        quads = self.make_quad_mesh(anisotropy=4)
        quads.Sources[0].touch()
        self.open(quads)
        with mock.patch.object(MeshWorker, "_poll", note):
            self.button("Apply").click()
            FreeCADGui.Control.closeDialog()
            self.assertTrue(wait(lambda: not any(thread.name == "AnisoQuad" for thread in threading.enumerate()), 30))
            wait(seconds=0.3)
            before = len(polls)
            self.assertGreater(before, 0)
            wait(seconds=0.5)
        self.assertEqual(len(polls), before)

    def test_a_side_without_rows_is_told_with_the_reason(self):
        entry = {"source": 0, "pass": 1, "ratio": 4, "side": "left", "rows": 5, "stopped": "as many rows as asked for"}
        passes = [entry, {**entry, "side": "right", "rows": 0, "stopped": "a column has become too slim"}]
        quads = SimpleNamespace(Quads=9, TrianglesIn=20, Reduction=55.0, MinScaledJacobian=0.5, MeanScaledJacobian=0.9, RegularNodes=99.0,
                                Report=json.dumps({"passes": passes, "warnings": []}))
        lines = [line for line in figures_text(quads).splitlines() if "no rows" in line]
        self.assertEqual(lines, ["Source 1 has no rows, right: a column has become too slim"])

    def test_the_sources_are_children_and_rows_are_previewed(self):
        quads = self.make_quad_mesh(anisotropy=16)
        self.assertEqual(quads.ViewObject.Proxy.claimChildren(), [self.base, *quads.Sources])
        self.assertEqual(quads.ViewObject.DisplayMode, "Faces & Wireframe")
        self.base.ViewObject.Visibility = False
        form = self.open(quads)
        table = form.findChild(object, "sources")
        self.assertEqual(table.rowCount(), 1)
        self.assertEqual(table.item(0, 2).text(), str(len(self.leading_edge) - 1))
        before = self.pixels_like((232, 89, 64))
        form.findChild(object, "preview").click()
        self.assertTrue(wait(lambda: not form.findChild(object, "cancel").isEnabled(), 30))
        self.assertGreater(self.pixels_like((232, 89, 64)), before + 500)
        self.screenshot("panel")

    def test_the_table_of_sources_shows_all_its_columns(self):
        large = Mesh.Mesh(self.base.Mesh)
        large.transform(FreeCAD.Matrix(1234.0, 0, 0, 0, 0, 1234.0, 0, 0, 0, 0, 1234.0))
        self.base.Mesh = large
        self.doc.recompute()
        self.addCleanup(FreeCADGui.setLocale, "English")
        quads = self.make_quad_mesh(anisotropy=None, passes="4:6, 2, 2")
        quads.Sources[0].Label = "Leading edge of the left wing, from root to tip"
        for language, cancel, sides in (("English", "Cancel", "Sides"), ("German", "Abbrechen", "Seiten"), ("French", "Annuler", "Côtés"),
                                        ("Spanish", "Cancel", "Lados")):
            FreeCADGui.setLocale(language)
            table = self.open(quads).findChild(object, "sources")
            wait(seconds=0.3)
            self.assertEqual(table.horizontalHeaderItem(4).text(), sides)
            self.screenshot(f"sources_{language}")
            for column in range(table.columnCount()):
                with self.subTest(language, column=column):
                    left, width = table.columnViewportPosition(column), table.columnWidth(column)
                    self.assertGreaterEqual(left, 0)
                    self.assertLessEqual(left + width, table.viewport().width())
                    if column > 0:  # the name may be shortened, and is told by the tooltip
                        self.assertGreaterEqual(width, table.sizeHintForColumn(column))
            self.assertEqual(table.item(0, 0).toolTip(), quads.Sources[0].Label)
            self.button(cancel).click()
            wait()

    def test_numbers_have_no_more_decimals_than_they_need(self):
        quads = self.make_quad_mesh()
        quads.FeatureAngle, quads.Size, quads.Growth = 40.0, 0.0, 1.25
        form = self.open(quads)
        texts = [form.findChild(object, name).text().replace(",", ".") for name in ("FeatureAngle", "Size", "Growth")]
        self.assertEqual(texts, ["40°", "0", "1.25"])
        self.button("OK").click()
        self.assertEqual(quads.Growth, 1.25)

    def test_rows_that_are_known_are_previewed_at_once(self):
        quads = self.make_quad_mesh(anisotropy=16)
        form = self.open(quads)
        preview, stop = form.findChild(object, "preview"), form.findChild(object, "cancel")
        for passes, known in (("1:16", True), ("4:2", False), ("4:2", True)):
            form.findChild(object, "sources").item(0, 3).setText(passes)
            preview.setChecked(True)
            self.assertEqual(stop.isEnabled(), not known, passes)
            self.assertTrue(wait(lambda: not stop.isEnabled(), 30))
            self.assertGreater(self.pixels_like((232, 89, 64)), 100)
            preview.setChecked(False)

    def test_apply_changes_the_mesh_and_cancel_takes_it_back(self):
        quads = self.make_quad_mesh()
        before = quads.Quads, self.nodes(quads)
        form = self.open(quads)
        form.findChild(object, "sources").item(0, 3).setText("2:1")
        form.findChild(object, "order").setCurrentIndex(1)
        self.button("Apply").click()
        self.wait_for_mesh(form)
        self.assertEqual(quads.Sources[0].Passes, "2:1")
        self.assertEqual(quads.FemMesh.QuadrangleCount, quads.Quads)
        self.assertEqual(len(quads.FemMesh.getElementNodes(1)), 8)
        self.assertNotEqual(quads.Quads, before[0])
        self.button("Cancel").click()
        wait()
        self.assertEqual((quads.Quads, self.nodes(quads)), before)
        self.assertEqual((quads.ElementOrder, quads.Sources[0].Passes), ("1st", ""))

    def test_undo_and_redo_bring_the_quads_too(self):
        quads = self.make_quad_mesh()
        first = self.nodes(quads)
        form = self.open(quads)
        form.findChild(object, "sources").item(0, 3).setText("1:2")
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 60))
        second = self.nodes(quads)
        self.assertNotEqual(first, second)
        self.doc.undo()
        wait()
        self.assertEqual((quads.Sources[0].Anisotropy, self.nodes(quads)), (4, first))
        self.doc.redo()
        wait()
        self.assertEqual((quads.Sources[0].Anisotropy, self.nodes(quads)), (2, second))
        self.assertTrue(quads.isValid())

    def test_an_error_says_what_and_where_and_keeps_the_mesh(self):
        quads = self.make_quad_mesh()
        before = self.nodes(quads)
        form = self.open(quads)
        source = quads.Sources[0]
        source.Vertices = [self.leading_edge[0], self.leading_edge[50]]
        self.button("Apply").click()
        self.assertTrue(wait(lambda: "source" in form.findChild(object, "figures").text().lower(), 20), form.findChild(object, "figures").text())
        self.assertIn(str(self.leading_edge[50]), form.findChild(object, "figures").text())
        self.assertEqual(self.nodes(quads), before)
        self.screenshot("error")
        form.findChild(object, "sources").item(0, 3).setText("4:x")
        self.button("OK").click()
        self.assertIn("'x'", form.findChild(object, "figures").text())
        self.assertTrue(FreeCADGui.Control.activeDialog())

    def test_without_triangles_it_says_so(self):
        quads = self.make_quad_mesh()
        quads.Base = None
        form = self.open(quads)
        self.button("Apply").click()
        wait()
        self.assertIn("no triangle mesh is chosen", form.findChild(object, "figures").text())

    def test_stop_ends_meshing_and_keeps_the_mesh(self):
        quads = self.make_quad_mesh()
        before = self.nodes(quads)
        form = self.open(quads)
        form.findChild(object, "sources").item(0, 3).setText("1:3")
        self.button("Apply").click()
        form.findChild(object, "cancel").click()
        self.assertTrue(wait(lambda: not form.findChild(object, "cancel").isEnabled(), 20))
        self.assertIn("Stopped", form.findChild(object, "figures").text())
        self.assertEqual(self.nodes(quads), before)

    def test_escape_stops_a_recompute_without_a_panel(self):
        quads = self.make_quad_mesh()
        before = self.nodes(quads)
        source = quads.Sources[0]
        source.Anisotropy = 3
        QtCore.QTimer.singleShot(0, lambda: self.key(QtCore.Qt.Key_Escape))
        self.doc.recompute()
        self.assertIn("cancelled", quads.getStatusString())
        self.assertEqual(self.nodes(quads), before)
        source.Anisotropy = 4
        self.doc.recompute()
        self.assertEqual((quads.getStatusString(), self.nodes(quads)), ("Valid", before))

    def test_save_close_and_reopen(self):
        quads = self.make_quad_mesh()
        before = self.nodes(quads)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "wing.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        quads = self.doc.getObject("QuadMesh")
        self.assertEqual(self.nodes(quads), before)
        self.assertEqual(type(quads.ViewObject.Proxy).__name__, "QuadMeshViewProvider")
        self.assertEqual(type(quads.Sources[0].ViewObject.Proxy).__name__, "SourceViewProvider")
        form = self.open(quads)
        form.findChild(object, "sources").item(0, 3).setText("1:2")
        self.button("Apply").click()
        self.wait_for_mesh(form)
        self.assertNotEqual(self.nodes(quads), before)
        self.button("Cancel").click()
        wait()
        self.assertEqual(self.nodes(quads), before)

    def test_it_joins_the_active_analysis(self):
        analysis = ObjectsFem.makeAnalysis(self.doc, "Analysis")
        FemGui.setActiveAnalysis(analysis)
        self.select(self.base)
        self.run_command("AnisoQuad_QuadMesh")
        self.wait_for_mesh(self.panel("QuadMeshPanel"))
        self.assertIn(self.doc.getObject("QuadMesh"), analysis.Group)

    def test_a_part_shape_is_triangulated_first(self):
        box = self.doc.addObject("Part::Cylinder", "Tube")
        self.doc.recompute()
        self.select(box)
        self.run_command("AnisoQuad_QuadMesh")
        self.wait_for_mesh(self.panel("QuadMeshPanel"))
        quads = self.doc.getObject("QuadMesh")
        self.assertGreater(quads.Quads, 0, quads.getStatusString())
        self.assertIs(quads.Base.Shape, box)

    @staticmethod
    def nodes(quads):
        """A short text that differs when the nodes or the elements do."""
        mesh = quads.FemMesh
        content = sorted(mesh.Nodes.items()), [mesh.getElementNodes(face) for face in mesh.Faces]
        return f"{mesh.NodeCount} {mesh.FaceCount} {zlib.crc32(repr(content).encode()):08x}"
