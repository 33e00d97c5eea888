"""The workbench: its commands, menu, tool bar and preferences page."""

import FreeCAD
import FreeCADGui

from .resources import icon, icons, translations, ui_file


class AnisoQuadWorkbench(FreeCADGui.Workbench):
    """Anisotropic all-quad surface meshes."""

    MenuText = "AnisoQuad"
    ToolTip = "Anisotropic all-quad surface meshes from triangles, along picked lines"
    Icon = icon("anisoquad")

    def Initialize(self):
        FreeCADGui.addIconPath(icons())
        FreeCADGui.addLanguagePath(translations())
        FreeCADGui.updateLocale()
        FreeCADGui.addPreferencePage(ui_file("preferences"), "AnisoQuad")
        if not core_loads():
            return
        from .commands import all_commands
        from .commands.anisoquad import register

        commands = all_commands()
        register(filter(None, commands))
        names = [command.NAME if command is not None else "Separator" for command in commands]
        self.appendToolbar("AnisoQuad", names)
        self.appendMenu("AnisoQuad", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def core_loads():
    """True when the compiled core can be loaded; else the report view says what is wrong."""
    try:
        from . import _core  # noqa: F401
    except ImportError as error:
        FreeCAD.Console.PrintError(f"{error}\n")
        return False
    return True
