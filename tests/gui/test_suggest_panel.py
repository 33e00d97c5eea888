"""Leading edges that are found by themselves."""

import FreeCADGui
from PySide import QtCore
from window import WindowTest, wait


class SuggestPanel(WindowTest):
    def test_the_leading_edge_is_offered_and_taken(self):
        self.select(self.base)
        self.run_command("AnisoQuad_SuggestSources")
        form = self.panel("SuggestPanel")
        lines = form.findChild(object, "lines")
        self.assertGreaterEqual(lines.count(), 1)
        self.assertEqual([lines.item(row).checkState() for row in range(lines.count())],
                         [QtCore.Qt.Checked] + [QtCore.Qt.Unchecked] * (lines.count() - 1))
        self.screenshot("suggest")
        form.findChild(object, "anisotropy").setValue(8)
        self.button("OK").click()
        wait()
        source = self.doc.getObject("Source")
        self.assertIn(source.Vertices, (self.leading_edge, self.leading_edge[::-1]))
        self.assertEqual((source.Anisotropy, source.EdgeCount), (8, len(self.leading_edge) - 1))
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.doc.undo()
        self.assertIsNone(self.doc.getObject("Source"))

    def test_a_quad_mesh_gets_the_sources(self):
        quads = self.make_quad_mesh(sources=[])
        self.select(quads)
        self.run_command("AnisoQuad_SuggestSources")
        self.button("OK").click()
        wait()
        self.assertEqual([source.Name for source in quads.Sources], ["Source"])

    def test_cancel_makes_nothing(self):
        self.select(self.base)
        self.run_command("AnisoQuad_SuggestSources")
        self.button("Cancel").click()
        wait()
        self.assertEqual(len(self.doc.Objects), 1)

    def test_it_opens_as_often_as_one_likes(self):
        # The memory of a closed panel is used again: no widget may be taken for what was there before.
        for _ in range(40):
            self.select(self.base)
            FreeCADGui.runCommand("AnisoQuad_SuggestSources")
            wait(seconds=0.02)
            self.assertGreaterEqual(self.panel("SuggestPanel").findChild(object, "lines").count(), 1)
            self.button("Cancel").click()
            wait(seconds=0.01)


class LinesThatEndOnAnother(WindowTest):
    WING = "wing_swept"  # its leading and trailing edge end on the tip's outline

    def test_all_that_is_ticked_can_be_meshed(self):
        quads = self.make_quad_mesh(sources=[])
        self.select(quads)
        self.run_command("AnisoQuad_SuggestSources")
        form = self.panel("SuggestPanel")
        lines = form.findChild(object, "lines")
        offered = lines.count()
        for row in range(offered):
            lines.item(row).setCheckState(QtCore.Qt.Checked)
        form.findChild(object, "anisotropy").setValue(4)
        self.button("OK").click()
        wait()
        self.assertGreater(len(quads.Sources), offered)
        self.doc.recompute()
        self.assertIn("Up-to-date", quads.State)
        self.assertGreater(quads.Quads, 1000)
        self.assertGreater(quads.MinScaledJacobian, 0.0)
