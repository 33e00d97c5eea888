"""The workbench: its commands, menu and tool bar."""

from pathlib import Path

import FreeCADGui


class AnisoQuadWorkbench(FreeCADGui.Workbench):
    """Anisotropic all-quad surface meshes."""

    MenuText = "AnisoQuad"
    ToolTip = "Anisotropic all-quad surface meshes from triangles, along picked lines"
    Icon = str(Path(__file__).parents[2] / "resources" / "icons" / "anisoquad.svg")

    def Initialize(self):
        from .commands.quad_mesh_command import QuadMeshCommand

        FreeCADGui.addCommand(QuadMeshCommand.NAME, QuadMeshCommand())
        self.appendToolbar("AnisoQuad", [QuadMeshCommand.NAME])
        self.appendMenu("AnisoQuad", [QuadMeshCommand.NAME])

    def GetClassName(self):
        return "Gui::PythonWorkbench"
