"""Picking a source on the wing by the mouse."""

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore
from window import WindowTest, wait


class Picking(WindowTest):
    def setUp(self):
        super().setUp()
        self.select(self.base)
        self.run_command("AnisoQuad_AddSource")
        self.source = self.doc.getObject("Source")
        self.form = self.panel("SourcePanel")

    def on_leading_edge(self, index):
        """The middle of an edge of the leading edge."""
        return self.middle(self.leading_edge[index], self.leading_edge[index + 1])

    def test_two_clicks_take_the_edges_between_them(self):
        self.assertTrue(self.form.findChild(object, "pick").isChecked())
        self.click(self.on_leading_edge(10))
        self.assertTrue(self.form.findChild(object, "edges").text().startswith("1"))
        self.click(self.on_leading_edge(60))
        self.assertEqual(self.form.findChild(object, "edges").text(), "51")
        self.assertEqual(self.form.findChild(object, "aspect").text().split()[0], "1:16")
        self.screenshot("picking")
        self.button("OK").click()
        wait()
        self.assertIn(self.source.Vertices, (self.leading_edge[10:62], self.leading_edge[10:62][::-1]))
        self.assertEqual(self.source.EdgeCount, 51)
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_the_colour_of_a_selection_does_not_cover_the_line(self):
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        self.click(self.on_leading_edge(40), times=2)
        wait()
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        self.button("Cancel").click()
        wait()
        self.assertEqual(FreeCADGui.Selection.getSelection(), [self.base])

    def test_a_double_click_takes_the_whole_line(self):
        self.click(self.on_leading_edge(40), times=2)
        self.button("OK").click()
        wait()
        self.assertEqual(set(self.source.Vertices), set(self.leading_edge))

    def test_hover_lights_up_the_nearest_edge(self):
        self.hover(self.base.Mesh.BoundBox.Center + FreeCAD.Vector(0, 0, 1))
        inside = self.pixels_like((255, 204, 0))
        self.assertGreater(inside, 3)
        self.hover(FreeCAD.Vector(-0.2, 0.9, 0))
        self.assertLess(self.pixels_like((255, 204, 0)), inside)

    def test_a_perspective_view_is_picked_in_too(self):
        self.view.setCameraType("Perspective")
        self.view.viewTop()
        self.view.fitAll()
        wait()
        self.click(self.on_leading_edge(40), times=2)
        self.assertEqual(self.form.findChild(object, "edges").text(), str(len(self.leading_edge) - 1))
        self.view.setCameraType("Orthographic")

    def test_ctrl_click_cuts_and_esc_leaves(self):
        self.click(self.on_leading_edge(40), times=2)
        wait(seconds=0.6)
        self.click(self.on_leading_edge(20), QtCore.Qt.ControlModifier)
        self.assertEqual(self.form.findChild(object, "edges").text(), str(len(self.leading_edge) - 1 - 21))
        self.key(QtCore.Qt.Key_Escape)
        self.assertFalse(self.form.findChild(object, "pick").isChecked())
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.click(self.on_leading_edge(90))
        self.assertEqual(self.form.findChild(object, "edges").text(), str(len(self.leading_edge) - 1 - 21))

    def test_cancel_takes_everything_back(self):
        self.click(self.on_leading_edge(40), times=2)
        self.button("Cancel").click()
        wait()
        self.assertIsNone(self.doc.getObject("Source"))
        self.assertEqual(self.doc.UndoCount, 0)


class PartEdges(WindowTest):
    def test_edges_that_are_selected_in_the_view_are_the_line(self):
        tube = self.doc.addObject("Part::Cylinder", "Tube")
        self.doc.recompute()
        circle = next(f"Edge{i + 1}" for i, edge in enumerate(tube.Shape.Edges) if isinstance(edge.Curve, Part.Circle))
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(tube, circle)
        self.run_command("AnisoQuad_AddSource")
        form = self.panel("SourcePanel")
        self.assertFalse(form.findChild(object, "pick").isEnabled())
        self.assertIn("closed", form.findChild(object, "edges").text())
        self.button("OK").click()
        wait()
        source = self.doc.getObject("Source")
        self.assertEqual(source.Edges, (tube, [circle]))
        self.assertGreater(source.EdgeCount, 8)
        self.doc.undo()
        self.assertIsNone(self.doc.getObject("Triangles"))


class BadTriangles(WindowTest):
    def test_what_is_wrong_is_said_and_marked(self):
        mesh = self.base.Mesh.copy()
        corners = [mesh.Points[index].Vector for index in mesh.Facets[0].PointIndices]
        mesh.addFacet(corners[0], corners[1], corners[2] + FreeCAD.Vector(0, 0, 1))
        self.base.Mesh = mesh
        for command, name in (("AnisoQuad_AddSource", "SourcePanel"), ("AnisoQuad_SuggestSources", "SuggestPanel")):
            with self.subTest(name):
                self.select(self.base)
                self.run_command(command)
                self.assertIn("edge", self.panel(name).findChild(object, "hint").text().lower())
                self.assertGreater(self.pixels_like((255, 51, 0)), 10)
                self.button("Cancel").click()
                wait()
        self.assertEqual(len(self.doc.Objects), 1)
