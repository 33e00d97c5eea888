"""Registers the commands with FreeCAD.

FreeCAD writes an import of the file that registered a command into macros, by its bare name: hence this one has the package's.
"""

import FreeCADGui


def register(commands):
    """Make the Command objects known under their names."""
    for command in commands:
        FreeCADGui.addCommand(command.NAME, command)
