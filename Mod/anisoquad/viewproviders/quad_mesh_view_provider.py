"""How a quad mesh is shown."""

from pathlib import Path

_ICON = Path(__file__).parents[3] / "resources" / "icons" / "anisoquad.svg"


def attach(obj):
    """Give the object its view provider, also when it was saved without a GUI."""
    if obj.ViewObject is not None and not isinstance(obj.ViewObject.Proxy, QuadMeshViewProvider):
        QuadMeshViewProvider(obj.ViewObject)


class QuadMeshViewProvider:
    """Proxy of a FemGui::ViewProviderFemMeshPython."""

    def __init__(self, view):
        view.Proxy = self
        view.BackfaceCulling = False
        view.ShowInner = True  # otherwise it looks for inner faces, in quadratic time
        view.DisplayMode = "Faces & Wireframe"

    def attach(self, view):
        self.object = view.Object

    def claimChildren(self):
        return [self.object.Base] if self.object.Base else []

    def getIcon(self):
        return str(_ICON)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
