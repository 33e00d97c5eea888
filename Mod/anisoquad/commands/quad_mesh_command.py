"""The command that makes a quad mesh of the selected mesh."""

from pathlib import Path

import FreeCAD
import FreeCADGui

_ICON = Path(__file__).parents[3] / "resources" / "icons" / "anisoquad.svg"


class QuadMeshCommand:
    """Quad mesh from mesh."""

    NAME = "AnisoQuad_QuadMesh"

    def GetResources(self):
        return {
            "Pixmap": str(_ICON),
            "MenuText": "Quad mesh from mesh",
            "ToolTip": "Make an all-quad surface mesh of the selected triangle mesh",
        }

    def IsActive(self):
        return len(self._selected()) == 1

    def Activated(self):
        base = self._selected()[0]
        base.Document.openTransaction("Quad mesh from mesh")
        FreeCADGui.addModule("anisoquad")
        FreeCADGui.doCommand(
            f"anisoquad.make_quad_mesh(FreeCAD.ActiveDocument, base=FreeCAD.ActiveDocument.{base.Name})\n"
            "FreeCAD.ActiveDocument.recompute()"
        )
        base.Document.commitTransaction()

    @staticmethod
    def _selected():
        if FreeCAD.ActiveDocument is None:
            return []
        return [obj for obj in FreeCADGui.Selection.getSelection() if obj.isDerivedFrom("Mesh::Feature")]
