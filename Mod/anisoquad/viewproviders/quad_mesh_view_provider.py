"""How a quad mesh is shown."""

from ..objects.properties import SavedByProperties
from ..resources import icon
from .edited_in_panel import EditedInPanel


def attach(obj):
    """Give the object its view provider, also when it was saved without a GUI."""
    if obj.ViewObject is not None and not isinstance(obj.ViewObject.Proxy, QuadMeshViewProvider):
        QuadMeshViewProvider(obj.ViewObject)


class QuadMeshViewProvider(EditedInPanel, SavedByProperties):
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

    def make_panel(self, obj):
        from ..taskpanels.quad_mesh_panel import QuadMeshPanel

        return QuadMeshPanel(obj)
