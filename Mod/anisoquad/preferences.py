"""What the user prefers, kept in FreeCAD's parameters. The preferences page writes the same names."""

import FreeCAD

_GROUP = "User parameter:BaseApp/Preferences/Mod/AnisoQuad"


def anisotropy():
    """Maximum anisotropy of a new source."""
    return FreeCAD.ParamGet(_GROUP).GetInt("Anisotropy", 16)


def element_order():
    """Element order of a new quad mesh, 1 or 2."""
    return FreeCAD.ParamGet(_GROUP).GetInt("ElementOrder", 0) + 1


def hide_base():
    """True when the triangles are hidden once the quads are there."""
    return FreeCAD.ParamGet(_GROUP).GetBool("HideBase", True)


def line_width():
    """Width of picked lines, in pixels."""
    return FreeCAD.ParamGet(_GROUP).GetInt("LineWidth", 4)
