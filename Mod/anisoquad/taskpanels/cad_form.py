"""Fields of the quad mesh panel for what is made on a CAD shape."""

from ..cad import has_cad
from ..commands.command import reference
from ..objects.triangles_object import TRIANGULATORS, is_triangles


class CadForm:
    """Triangulator of the base, nodes onto the shape, faces that are joined; off, and hidden, where the base is not that of a Part shape."""

    def __init__(self, form, obj):
        self._form = form
        self._obj = obj
        form.triangulator.addItems(TRIANGULATORS)
        form.ontoShape.setChecked(obj.OntoShape)
        form.smoothAngle.setValue(obj.SmoothAngle.Value)
        form.ontoShape.toggled.connect(self._enable)

    def show(self, base):
        """Show what goes with this mesh object, or None."""
        shape = is_triangles(base)
        self._form.cadBox.setEnabled(shape)
        self._form.cadBox.setVisible(shape)
        self._form.triangulator.setCurrentIndex(TRIANGULATORS.index(base.Triangulator) if shape else 0)
        self._enable()

    def changes(self):
        """{property of the quad mesh object: new value} of what differs."""
        changes = {}
        if self._form.ontoShape.isChecked() != self._obj.OntoShape:
            changes["OntoShape"] = self._form.ontoShape.isChecked()
        if abs(self._form.smoothAngle.value() - self._obj.SmoothAngle.Value) > 0.5 * 10.0 ** -self._form.smoothAngle.decimals():
            changes["SmoothAngle"] = self._form.smoothAngle.value()
        return changes

    def triangle_lines(self, base, changes):
        """Macro lines that give the base what is chosen; changes -- what the quad mesh object gets, of which Gmsh takes some."""
        if not is_triangles(base):
            return []
        chosen = TRIANGULATORS[self._form.triangulator.currentIndex()]
        values = {}
        if chosen != base.Triangulator:
            values["Triangulator"] = chosen
        if chosen == "Gmsh":
            values.update({name: changes.get(name, getattr(self._obj, name)) for name in ("Size", "CurvatureAngle")
                           if values or name in changes})
        return [f"{reference(base)}.{name} = {value!r}" for name, value in values.items()]

    def _enable(self, *_):
        shape = self._form.cadBox.isEnabled() and has_cad()
        self._form.ontoShape.setEnabled(shape)
        self._form.smoothAngle.setEnabled(shape and self._form.ontoShape.isChecked())
