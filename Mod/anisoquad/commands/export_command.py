"""The command that writes a quad mesh to a file."""

import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from ..compat import qt_widgets, translate
from .command import Command, record, reference
from .selection import selected_quad_mesh

_FILTERS = "VTK (*.vtu);;CalculiX, Abaqus (*.inp);;Gmsh (*.msh);;SU2 (*.su2);;Wavefront (*.obj)"


class ExportCommand(Command):
    """Asks for a file, and writes the selected quad mesh."""

    NAME = "AnisoQuad_Export"
    MENU = QT_TRANSLATE_NOOP("AnisoQuad_Export", "Export")
    TOOLTIP = QT_TRANSLATE_NOOP("AnisoQuad_Export", "Write the selected quad mesh as .vtu, .inp, .msh, .su2 or .obj")
    WHATS_THIS = QT_TRANSLATE_NOOP("AnisoQuad_Export",
                                   "Writes the selected quad mesh to a file: .vtu for ParaView, .inp for CalculiX and Abaqus, .msh "
                                   "for Gmsh, .su2 for SU2, .obj for other programs. Patches, rows, feature lines and sources are "
                                   "kept as named sets where the format has them.")
    ICON = "export"
    SHORTCUT = "Q, X"

    def IsActive(self):
        quads = selected_quad_mesh()
        return super().IsActive() and quads is not None and quads.Quads > 0

    def Activated(self):
        title = translate("AnisoQuad_Export", "Export quad mesh")
        path, _ = qt_widgets().QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, "", _FILTERS)
        if path:
            export(selected_quad_mesh(), path)


def export(quads, path):
    """Write the quad mesh; recorded."""
    record(f"anisoquad.export_quad_mesh({reference(quads)}, {path!r})")
