"""The command that shows the quality of a quad mesh."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .command import Command
from .selection import selected_quad_mesh


class QualityCommand(Command):
    """Opens the quality panel."""

    NAME = "AnisoQuad_Quality"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_Quality", "Quality")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_Quality", "Colour the selected quad mesh by its quality, and list the worst quads")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_Quality",
                                   "Colours the selected quad mesh by a measure of its quads: scaled Jacobian, aspect ratio, skew, "
                                   "size or row. Red is bad, blue is good. The panel shows the measure's histogram, and lists the "
                                   "worst quads; a click on one zooms to it. Closing the panel brings the mesh's own look back.")
    ICON = "quality"
    SHORTCUT = "Q, Q"

    def IsActive(self):
        quads = selected_quad_mesh()
        return super().IsActive() and quads is not None and quads.Quads > 0

    def Activated(self):
        from ..taskpanels.quality_panel import QualityPanel

        FreeCADGui.Control.showDialog(QualityPanel(selected_quad_mesh()))
