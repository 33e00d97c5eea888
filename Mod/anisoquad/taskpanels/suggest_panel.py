"""The panel that offers leading and trailing edges as sources."""

import FreeCAD
import FreeCADGui
from PySide import QtCore

from .. import preferences
from ..commands.add_source_command import add_source
from ..commands.command import transaction
from ..commands.selection import SetAside, quad_meshes_on
from ..compat import button_box, load_ui, qt_widgets, translate
from ..errors import MeshError
from ..objects.base_mesh import base_arrays
from ..resources import ui_file
from ..surface_lines import SurfaceLines, cut_at_ends
from ..viewproviders.line_node import LineNode
from .highlight import Highlight

_COLOUR, _CURRENT_COLOUR = (0.96, 0.47, 0.0), (0.80, 0.0, 0.0)


class SuggestPanel:
    """Task panel: a list of lines, ticked are made into sources."""

    def __init__(self, base, quads=None):
        """base -- the Mesh::Feature; quads -- the quad mesh that gets the sources; None: all on this base"""
        self.base = base
        self.quad_meshes = [quads] if quads else quad_meshes_on(base)
        self.form = load_ui(ui_file("suggest"))
        self.form.anisotropy.setValue(preferences.anisotropy())
        self.highlight = Highlight(FreeCADGui.ActiveDocument.ActiveView)
        self.set_aside = SetAside(base)
        self.lines = self._suggest()
        self._scene = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        self._all, self._current = LineNode(_COLOUR, 4), LineNode(_CURRENT_COLOUR, 7)
        for node in (self._all, self._current):
            self._scene.addChild(node.root)
        self._fill()
        self.form.lines.itemChanged.connect(self._show)
        self.form.lines.currentRowChanged.connect(self._show)

    def _suggest(self):
        """The lines; none, with the reason shown and marked, where the triangles can not be meshed."""
        try:
            self.surface = SurfaceLines(*base_arrays(self.base))
        except MeshError as error:
            self.form.hint.setText(str(error))
            self.highlight.show(error, self.base)
            return []
        lines = self.surface.suggest()
        if not lines:
            self.form.hint.setText(translate("SuggestPanel", "No long, smooth ridge was found. Pick the line in the view instead."))
        return lines

    def getStandardButtons(self):
        return button_box("Ok", "Cancel")

    def accept(self):
        chosen = self.ticked()
        if chosen:
            with transaction(FreeCAD.ActiveDocument, "Suggest leading edges"):
                for line in cut_at_ends(chosen):
                    add_source(self.base, self.quad_meshes, self.form.anisotropy.value(), vertices=line).recompute()
        return self.reject()

    def reject(self):
        for node in (self._all, self._current):
            self._scene.removeChild(node.root)
        self.highlight.remove()
        self.set_aside.back()
        FreeCADGui.Control.closeDialog()
        return True

    def ticked(self):
        """The lines that are ticked, as vertex ids."""
        return [line for row, line in enumerate(self.lines) if self.form.lines.item(row).checkState() == QtCore.Qt.Checked]

    def _fill(self):
        for index, line in enumerate(self.lines):
            length = FreeCAD.Units.Quantity(self.surface.length(line), FreeCAD.Units.Length).UserString
            text = translate("SuggestPanel", "Line {index}: {length}, {edges} edges").format(index=index + 1, length=length, edges=len(line) - 1)
            item = qt_widgets().QListWidgetItem(text, self.form.lines)
            item.setCheckState(QtCore.Qt.Checked if index == 0 else QtCore.Qt.Unchecked)
        self._show()

    def _show(self, *_):
        coordinates = [[tuple(point) for point in self.surface.points[line].tolist()] for line in self.lines]
        row = self.form.lines.currentRow()
        self._all.show(coordinates)
        self._current.show(coordinates[row : row + 1] if row >= 0 else [])
