"""What is selected, as the commands need it."""

import FreeCAD
import FreeCADGui

from ..compat import is_shape


def selected():
    """The selected objects of the active document."""
    return FreeCADGui.Selection.getSelection() if FreeCAD.ActiveDocument else []


def only(condition):
    """The one selected object, when it is the only one and meets the condition; else None."""
    objects = selected()
    return objects[0] if len(objects) == 1 and condition(objects[0]) else None


class SetAside:
    """Takes an object out of the selection, whose colour would cover what is drawn over it, until back()."""

    def __init__(self, obj):
        self._obj = obj
        self._was_selected = obj in selected()
        self.again()

    def again(self):
        """Take it out once more: FreeCAD selects what is double-clicked."""
        if self._obj is not None and self._obj in selected():
            FreeCADGui.Selection.removeSelection(self._obj)

    def back(self):
        """Select it again, unless something else is selected by now. May be called again."""
        if self._obj is not None and self._was_selected and not selected():
            FreeCADGui.Selection.addSelection(self._obj)
        self._obj = None


def is_mesh(obj):
    return obj.isDerivedFrom("Mesh::Feature")


def is_mesh_or_shape(obj):
    return is_mesh(obj) or is_shape(obj)


def selected_quad_mesh():
    from ..objects.quad_mesh_object import is_quad_mesh

    return only(is_quad_mesh)


def selected_source():
    from ..objects.source_object import is_source

    return only(is_source)


def selected_edges():
    """(Part object, ["Edge1", …]) when only edges of one Part object are selected, else None."""
    chosen = FreeCADGui.Selection.getSelectionEx() if FreeCAD.ActiveDocument else []
    if len(chosen) != 1 or not chosen[0].SubElementNames or not is_shape(chosen[0].Object):
        return None
    names = list(chosen[0].SubElementNames)
    return (chosen[0].Object, names) if all(name.startswith("Edge") for name in names) else None


def quad_meshes_on(base):
    """The quad mesh objects of a triangle mesh."""
    from ..objects.quad_mesh_object import is_quad_mesh

    return [obj for obj in base.InList if is_quad_mesh(obj) and obj.Base is base]


def free_sources(base):
    """The source objects on a triangle mesh that no quad mesh uses yet."""
    from ..objects.source_object import is_source

    used = [source for quads in quad_meshes_on(base) for source in quads.Sources]
    return [obj for obj in base.InList if is_source(obj) and obj not in used]
