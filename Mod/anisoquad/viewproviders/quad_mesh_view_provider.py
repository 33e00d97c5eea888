"""How a quad mesh is shown."""

import FreeCADGui

from ..objects.properties import SavedByProperties
from ..resources import icon


def attach(obj):
    """Give the object its view provider, also when it was saved without a GUI."""
    if obj.ViewObject is not None and not isinstance(obj.ViewObject.Proxy, QuadMeshViewProvider):
        QuadMeshViewProvider(obj.ViewObject)


class QuadMeshViewProvider(SavedByProperties):
    """Proxy of a FemGui::ViewProviderFemMeshPython."""

    def __init__(self, view):
        view.Proxy = self
        view.BackfaceCulling = False
        view.ShowInner = True  # otherwise it looks for inner faces, in quadratic time
        view.DisplayMode = "Faces & Wireframe"

    def attach(self, view):
        self.object = view.Object

    def claimChildren(self):
        base = [self.object.Base] if self.object.Base else []
        return base + self.object.Sources

    def getIcon(self):
        return icon("anisoquad")

    def doubleClicked(self, view):
        FreeCADGui.ActiveDocument.setEdit(view.Object.Name)
        return True

    def setEdit(self, view, mode):
        from ..taskpanels.quad_mesh_panel import QuadMeshPanel

        if mode != 0:
            return None
        FreeCADGui.Control.showDialog(QuadMeshPanel(view.Object))
        return True

    def unsetEdit(self, view, mode):
        if mode != 0:
            return None
        FreeCADGui.Control.closeDialog()
        return True
