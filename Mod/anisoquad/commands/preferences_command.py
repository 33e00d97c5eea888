"""The command that opens the workbench's preferences."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .command import Command


class PreferencesCommand(Command):
    """Opens the preferences at our page."""

    NAME = "AnisoQuad_Preferences"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_Preferences", "Preferences")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_Preferences", "Defaults of new quad meshes and sources")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_Preferences",
                                   "Opens the preferences of the workbench: the anisotropy of new sources, the element order of new "
                                   "quad meshes, whether the triangles are hidden once the quads are there, and the width of the "
                                   "lines of sources.")
    ICON = "preferences-anisoquad"

    def IsActive(self):
        return True

    def Activated(self):
        FreeCADGui.showPreferences("AnisoQuad", 0)
