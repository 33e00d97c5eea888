"""The quality view: colours, histogram, worst quads; also for many quads."""

import time

import anisoquad
import FreeCAD
import FreeCADGui
import numpy as np
from window import WindowTest, wait

from anisoquad.objects.quad_mesh_object import result_of
from anisoquad.quality_measures import MEASURES
from anisoquad.viewproviders.quality_overlay import QualityOverlay


class QualityPanel(WindowTest):
    def open(self, obj):
        self.select(obj)
        self.run_command("AnisoQuad_Quality")
        return self.panel("QualityPanel")

    def test_the_view_is_coloured_by_every_measure(self):
        quads = self.make_quad_mesh(anisotropy=16)
        self.view.viewIsometric()
        self.view.fitAll()
        before = self.pixels_like((33, 102, 172))
        form = self.open(quads)
        seen = set()
        for index, name in enumerate(MEASURES):
            with self.subTest(name):
                form.findChild(object, "measure").setCurrentIndex(index)
                picture = tuple(self.pixels_like(colour) for colour in ((33, 102, 172), (179, 5, 38), (248, 248, 204)))
                self.assertNotIn(picture, seen, "the picture did not change")
                seen.add(picture)
                self.assertFalse(form.findChild(object, "histogram").pixmap().isNull())
        form.findChild(object, "measure").setCurrentIndex(0)
        self.assertGreater(self.pixels_like((33, 102, 172)), before + 2000, "good quads are blue")
        self.screenshot("quality")
        self.button("Close").click()
        wait()
        self.assertTrue(quads.ViewObject.Visibility)
        self.assertLess(self.pixels_like((33, 102, 172)), before + 100)

    def test_the_worst_quads_are_listed_and_a_click_zooms(self):
        quads = self.make_quad_mesh()
        form = self.open(quads)
        table = form.findChild(object, "worst")
        mesh = result_of(quads)
        values = MEASURES["scaled_jacobian"].compute(mesh)
        self.assertEqual(table.item(0, 0).text(), str(int(np.argmin(values)) + 1))
        self.assertEqual(table.item(0, 0).text(), str(mesh.report["scaled_jacobian"]["worst"] + 1))
        table.selectRow(3)
        wait()
        quad = int(table.item(3, 0).text()) - 1
        x, y = self.view.getPointOnScreen(FreeCAD.Vector(*mesh.points[mesh.quads[quad]].mean(axis=0)))
        width, height = self.view.getSize()
        self.assertLess(abs(x - width / 2), 3)
        self.assertLess(abs(y - height / 2), 3)
        self.assertGreater(self.pixels_like((255, 0, 255)), 20, "the quad is outlined")

    def test_a_hundred_thousand_quads(self):
        side = 316
        x, y = np.meshgrid(np.arange(side + 1.0), np.arange(side + 1.0))
        points = np.column_stack([x.ravel(), y.ravel(), np.sin(x / 20).ravel()])
        corner = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
        cells = np.column_stack([corner, corner + 1, corner + side + 2, corner + side + 1]).astype(np.int32)
        count = len(cells)
        mesh = anisoquad.QuadMesh(points, cells, np.zeros(count, np.int32), np.zeros(count, np.int32), np.full(count, -1, np.int32),
                                  np.zeros(count, np.int32), np.full(len(points), -1, np.int32), np.full(len(points), -1, np.int32),
                                  np.empty((0, 3), np.int32), {})
        started = time.monotonic()
        overlay = QualityOverlay(FreeCADGui.ActiveDocument.ActiveView, mesh)
        for measure in MEASURES.values():
            overlay.show(measure, measure.compute(mesh))
        taken = time.monotonic() - started
        overlay.remove()
        print(f"five measures of {count} quads: {taken:.2f} s")
        self.assertLess(taken, 10.0)
