"""How the triangles of a Part object are shown."""

from ..objects.properties import SavedByProperties


def attach(obj):
    """Give the object its view provider, also when it was saved without a GUI."""
    if obj.ViewObject is not None and not isinstance(obj.ViewObject.Proxy, TrianglesViewProvider):
        TrianglesViewProvider(obj.ViewObject)


class TrianglesViewProvider(SavedByProperties):
    """Proxy of a MeshGui::ViewProviderPython."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.object = view.Object

    def claimChildren(self):
        return [self.object.Shape] if self.object.Shape else []
