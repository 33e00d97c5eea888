"""The panel of a source: picks its line in the view, and sets how anisotropic it is."""

import FreeCAD
import FreeCADGui
from PySide import QtCore

from ..commands.command import open_transaction, record, reference
from ..commands.selection import SetAside
from ..compat import button_box, load_ui, translate
from ..errors import MeshError
from ..objects.base_mesh import base_arrays
from ..pick_path import PickPath
from ..picking.edge_picker import EdgePicker
from ..resources import ui_file
from ..source import parse_passes, passes_for_anisotropy
from ..surface_lines import SurfaceLines
from .highlight import Highlight

_SIDES = ("both", "left", "right")


class SourcePanel:
    """Task panel of a source object. OK keeps, Cancel takes back everything since the panel was opened."""

    def __init__(self, obj):
        self.obj = obj
        open_transaction(obj.Document, f"Edit {obj.Label}")
        if obj.Edges:
            obj.recompute()
        self.form = load_ui(ui_file("source"))
        self.form.anisotropy.setValue(obj.Anisotropy)
        self.form.passes.setText(obj.Passes)
        self.form.sides.setCurrentIndex(_SIDES.index(obj.Sides))
        self.form.imprint.setChecked(obj.Imprint)
        self.highlight = Highlight(FreeCADGui.ActiveDocument.ActiveView)
        self.picker = None
        self.set_aside = SetAside(obj.Base)
        self.path = PickPath(self._surface(), obj.Vertices)
        self.form.pick.setEnabled(self.path.lines is not None and not obj.Edges)
        self.form.pick.toggled.connect(self._toggle_picking)
        self.form.anisotropy.valueChanged.connect(self.show_figures)
        self.form.passes.textChanged.connect(self.show_figures)
        self.show_figures()
        self.form.pick.setChecked(self.form.pick.isEnabled() and not obj.Vertices)

    def _surface(self):
        """The SurfaceLines of the base; None, with the reason shown and marked, where its triangles can not be meshed."""
        try:
            return SurfaceLines(*base_arrays(self.obj.Base))
        except MeshError as error:
            self.form.hint.setText(str(error))
            self.highlight.show(error, self.obj.Base)
            return None

    def getStandardButtons(self):
        return button_box("Ok", "Cancel")

    def accept(self):
        if not self._write():
            return False
        self._leave()
        record(f"{reference(self.obj)}.recompute()")
        FreeCAD.ActiveDocument.commitTransaction()
        FreeCADGui.ActiveDocument.resetEdit()
        return True

    def reject(self):
        self._leave()
        FreeCAD.ActiveDocument.abortTransaction()
        FreeCADGui.ActiveDocument.resetEdit()
        return True

    def show_figures(self, *_):
        """Length, edges and aspect, as the path and the passes are now."""
        if self.path.lines is None:
            return
        length = FreeCAD.Units.Quantity(self.path.length, FreeCAD.Units.Length)
        self.form.length.setText(length.UserString)
        closed = " " + translate("SourcePanel", "(closed)") if self.path.closed else ""
        self.form.edges.setText(f"{self.path.edge_count}{closed}")
        try:
            ratios = [ratio for ratio, _ in self._passes()]
        except MeshError as error:
            self.form.aspect.setText(str(error))
            return
        self.form.aspect.setText("1:" + str(_product(ratios)) + (f"   ({' · '.join(map(str, ratios))})" if len(ratios) > 1 else ""))

    def _passes(self):
        text = self.form.passes.text().strip()
        return parse_passes(text) if text else passes_for_anisotropy(self.form.anisotropy.value())

    def _toggle_picking(self, on):
        if on and self.picker is None:
            self.picker = EdgePicker(FreeCADGui.ActiveDocument.ActiveView, self.path, self._picked, self._esc)
        elif not on and self.picker is not None:
            self.picker.stop()
            self.picker = None

    def _picked(self):
        QtCore.QTimer.singleShot(0, self.set_aside.again)
        if self.path.edge_count > 1:
            self.form.imprint.setChecked(self.path.lines.is_zigzag(self.path.vertices))
        self.show_figures()

    def _esc(self):
        self.form.pick.setChecked(False)

    def _leave(self):
        self._toggle_picking(False)
        self.highlight.remove()
        self.set_aside.back()

    def _write(self):
        """Set the object's properties; recorded. False, with a message, when they can not be read."""
        form, name = self.form, reference(self.obj)
        try:
            self._passes()
        except MeshError as error:
            form.aspect.setText(str(error))
            return False
        if self.path.edge_count == 0 and not self.obj.Edges:
            form.edges.setText(translate("SourcePanel", "Pick a line first"))
            return False
        values = {"Vertices": self.path.vertices, "Anisotropy": form.anisotropy.value(), "Passes": form.passes.text().strip(),
                  "Sides": _SIDES[form.sides.currentIndex()], "Imprint": form.imprint.isChecked()}
        if self.obj.Edges:
            del values["Vertices"]
        for property_, value in values.items():
            if getattr(self.obj, property_) != value:
                record(f"{name}.{property_} = {value!r}")
        return True


def _product(ratios):
    product = 1
    for ratio in ratios:
        product *= ratio
    return product
