"""The command that finds leading and trailing edges by itself."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .command import Command
from .selection import is_mesh, only, selected_quad_mesh


class SuggestSourcesCommand(Command):
    """Opens a panel that offers long, smooth ridges as sources."""

    NAME = "AnisoQuad_SuggestSources"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_SuggestSources", "Suggest leading edges")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_SuggestSources", "Find the leading and trailing edges of the selected mesh")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_SuggestSources",
                                   "Looks for long, smooth ridges of the selected mesh, as leading and trailing edges are, and lists "
                                   "them in a panel. Those that are ticked become sources. With a quad mesh selected, that one gets "
                                   "them.")
    ICON = "suggest"
    SHORTCUT = "Q, S"

    def IsActive(self):
        return super().IsActive() and bool(selected_quad_mesh() or only(is_mesh))

    def Activated(self):
        from ..taskpanels.suggest_panel import SuggestPanel

        quads = selected_quad_mesh()
        FreeCADGui.Control.showDialog(SuggestPanel(quads.Base if quads else only(is_mesh), quads))
