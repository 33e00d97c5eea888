"""The command that opens the workbench's preferences."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .command import Command


class PreferencesCommand(Command):
    """Opens the preferences at our page."""

    NAME = "AnisoQuad_Preferences"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_Preferences", "Preferences")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_Preferences", "Defaults of new quad meshes and sources")
    ICON = "preferences-anisoquad"

    def IsActive(self):
        return True

    def Activated(self):
        FreeCADGui.showPreferences("AnisoQuad", 0)
