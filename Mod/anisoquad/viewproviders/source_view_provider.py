"""How a source is shown: its line, over the model."""

from .. import preferences
from ..objects.properties import SavedByProperties
from ..resources import icon
from .edited_in_panel import EditedInPanel
from .line_node import LineNode

COLOUR = (0.80, 0.0, 0.0)


def attach(obj):
    """Give the object its view provider, also when it was saved without a GUI."""
    if obj.ViewObject is not None and not isinstance(obj.ViewObject.Proxy, SourceViewProvider):
        SourceViewProvider(obj.ViewObject)


class SourceViewProvider(EditedInPanel, SavedByProperties):
    """Proxy of a Gui::ViewProviderPythonFeature."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.object = view.Object
        self._line = LineNode(COLOUR, preferences.line_width())
        view.addDisplayMode(self._line.root, "Line")
        self.updateData(view.Object, "Points")

    def getDisplayModes(self, view):
        return ["Line"]

    def getDefaultDisplayMode(self):
        return "Line"

    def updateData(self, obj, property_):
        if property_ == "Points" and "Points" in obj.PropertiesList:
            self._line.show([[tuple(point) for point in obj.Points]])

    def getIcon(self):
        return icon("source")

    def make_panel(self, obj):
        from ..taskpanels.source_panel import SourcePanel

        return SourcePanel(obj)
