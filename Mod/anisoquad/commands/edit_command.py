"""The command that opens the panel of a quad mesh or a source."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .command import Command
from .selection import selected_quad_mesh, selected_source


class EditCommand(Command):
    """Opens the panel, as a double click does."""

    NAME = "AnisoQuad_Edit"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_Edit", "Edit")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_Edit", "Change the selected quad mesh or source")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_Edit",
                                   "Opens the panel of the selected quad mesh or source, as a double click in the tree does. Cancel "
                                   "takes back everything that was changed in it.")
    ICON = "edit"
    SHORTCUT = "Q, E"

    def IsActive(self):
        return super().IsActive() and bool(selected_quad_mesh() or selected_source())

    def Activated(self):
        obj = selected_quad_mesh() or selected_source()
        FreeCADGui.ActiveDocument.setEdit(obj.Name)
