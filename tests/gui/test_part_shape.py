"""A wing lofted in the document: its leading edge selected in the view, quads on the shape, the span changed."""

import json
import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
import Part
from window import WindowTest, wait

sys.path.append(str(Path(__file__).resolve().parents[1] / "freecad"))


class LoftWing(WindowTest):
    def setUp(self):
        super().setUp()
        from shapes import leading_edge, loft_wing

        self.doc.removeObject(self.base.Name)
        self.wing = loft_wing(self.doc)
        self.edge = leading_edge(self.wing)
        self.view.viewAxonometric()
        self.view.fitAll()
        wait(seconds=0.3)

    def mesh(self):
        """Select the edge in the view, add the source, mesh from its triangles. Returns the quad mesh object."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.wing, self.edge)
        wait(seconds=0.2)
        self.screenshot("part_edge_selected")
        self.run_command("AnisoQuad_AddSource")
        self.assertFalse(self.panel("SourcePanel").findChild(object, "pick").isEnabled())
        self.button("OK").click()
        wait()
        source = self.doc.getObject("Source")
        self.assertEqual(source.Edges, (self.wing, [self.edge]))
        self.doc.openTransaction("source")
        source.Anisotropy = 16
        self.doc.commitTransaction()
        self.select(self.wing)
        self.run_command("AnisoQuad_QuadMesh")
        form = self.panel("QuadMeshPanel")
        self.wait_for_mesh(form)
        self.button("OK").click()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 60))
        quads = self.doc.getObject("QuadMesh")
        self.doc.openTransaction("size")
        quads.Size = 50.0
        self.doc.recompute()
        self.doc.commitTransaction()
        return quads

    def assert_on_shape(self, quads):
        self.assertEqual(quads.getStatusString(), "Valid")
        report = json.loads(quads.Report)
        self.assertEqual((report["inverted"], report["triangles_left"]), (0, 0))
        shape = self.wing.Shape
        nodes = list(quads.FemMesh.Nodes.values())[::7]
        self.assertLess(max(shape.distToShape(Part.Vertex(*node))[0] for node in nodes), 1e-7 * shape.BoundBox.DiagonalLength)
        self.assertTrue(any(entry["rows"] for entry in report["passes"]))

    def test_the_edge_is_a_source_and_the_mesh_follows_the_span(self):
        quads = self.mesh()
        self.assert_on_shape(quads)
        self.wing.ViewObject.Visibility = False
        self.view.fitAll()
        wait(seconds=0.3)
        self.screenshot("part_wing")
        before = quads.FemMesh.BoundBox.YMax
        self.doc.openTransaction("span")
        self.doc.WingTip.Placement.Base = FreeCAD.Vector(0.25 * 500.0 + 0.2 * 1300.0, 1300.0, 0.0)
        self.doc.recompute()
        self.doc.commitTransaction()
        wait(seconds=0.3)
        self.assert_on_shape(quads)
        self.assertAlmostEqual(quads.FemMesh.BoundBox.YMax, before + 300.0, places=6)
        self.assertEqual(quads.Sources[0].Edges, (self.wing, [self.edge]))
        self.view.fitAll()
        wait(seconds=0.3)
        self.screenshot("part_wing_longer")
