"""The panel that shows the quality of a quad mesh: colours, histogram, the worst quads."""

import FreeCADGui
import numpy as np

from ..compat import button_box, load_ui, qt_widgets, translate
from ..objects.quad_mesh_object import result_of
from ..quality_measures import MEASURES
from ..resources import ui_file
from ..viewproviders.quality_overlay import QualityOverlay
from .histogram import histogram

_LISTED = 50


class QualityPanel:
    """Task panel; closing it brings the mesh's own look back."""

    def __init__(self, obj):
        self.obj = obj
        self.mesh = result_of(obj)
        self.view = FreeCADGui.ActiveDocument.ActiveView
        self.form = load_ui(ui_file("quality"))
        self._hidden = [other for other in (obj, obj.Base) if other is not None and other.ViewObject.Visibility]
        for other in self._hidden:
            other.ViewObject.Visibility = False
        self.overlay = QualityOverlay(self.view, self.mesh)
        self.form.measure.addItems([translate("QualityPanel", measure.title) for measure in MEASURES.values()])
        self.form.worst.horizontalHeader().setSectionResizeMode(qt_widgets().QHeaderView.Stretch)
        self.form.measure.currentIndexChanged.connect(self.show)
        self.form.worst.itemSelectionChanged.connect(self._zoom)
        self.show()

    def getStandardButtons(self):
        return button_box("Close")

    def reject(self):
        self.overlay.remove()
        for other in self._hidden:
            other.ViewObject.Visibility = True
        FreeCADGui.Control.closeDialog()
        return True

    def show(self, *_):
        """Show the chosen measure."""
        measure = list(MEASURES.values())[self.form.measure.currentIndex()]
        values = measure.compute(self.mesh)
        self.overlay.mark([])
        self.overlay.show(measure, values)
        self.form.range.setText(translate("QualityPanel", "{low:.4g} … {high:.4g}, mean {mean:.4g}").format(
            low=values.min(), high=values.max(), mean=values.mean()))
        picture = histogram(values, translate("QualityPanel", measure.title), 300, 170)
        if picture is None:
            self.form.histogram.setText(translate("QualityPanel", "matplotlib is not installed: no histogram"))
        else:
            self.form.histogram.setPixmap(picture)
        self._list(measure.worst_ids(values, _LISTED), values)

    def _list(self, ids, values):
        table = self.form.worst
        table.setRowCount(0)
        self.listed = ids.tolist()
        table.setRowCount(len(self.listed))
        for row, quad in enumerate(self.listed):
            table.setItem(row, 0, qt_widgets().QTableWidgetItem(str(quad + 1)))
            table.setItem(row, 1, qt_widgets().QTableWidgetItem(f"{values[quad]:.4g}"))

    def _zoom(self):
        """Bring the selected quads into the middle of the view."""
        rows = sorted({index.row() for index in self.form.worst.selectedIndexes()})
        ids = [self.listed[row] for row in rows]
        self.overlay.mark(ids)
        if ids:
            corners = self.mesh.points[self.mesh.quads[ids].ravel()]
            look_at(self.view, corners.mean(axis=0), 8.0 * max(np.linalg.norm(np.ptp(corners, axis=0)), 1e-12))


def look_at(view, centre, width):
    """Move a view's camera, without turning it, so that it shows this width around a point."""
    from pivy import coin

    camera = view.getCameraNode()
    direction = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    place = coin.SbVec3f(*map(float, centre))
    if isinstance(camera, coin.SoOrthographicCamera):
        camera.height = float(width)
        distance = camera.focalDistance.getValue()
    else:
        distance = float(width) / (2.0 * np.tan(camera.heightAngle.getValue() / 2.0))
        camera.focalDistance = distance
    camera.position = place - direction * distance
