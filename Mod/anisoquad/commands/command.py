"""What all commands share."""

from contextlib import contextmanager

import FreeCAD
import FreeCADGui

from ..resources import icon


class Command:
    """A command of the workbench; its texts are translated by FreeCAD in the context NAME.

    WHATS_THIS -- what Shift+F1 and a click on the command show: what it does, in a few sentences
    """

    NAME = ""
    MENU = ""
    TOOLTIP = ""
    WHATS_THIS = ""
    ICON = ""
    SHORTCUT = ""

    def GetResources(self):
        resources = {"Pixmap": icon(self.ICON), "MenuText": self.MENU, "ToolTip": self.TOOLTIP, "StatusTip": self.TOOLTIP,
                     "WhatsThis": self.WHATS_THIS}
        if self.SHORTCUT:
            resources["Accel"] = self.SHORTCUT
        return resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self):
        raise NotImplementedError


def open_transaction(doc, name):
    """Begin a step of undo, unless the caller of the caller began one."""
    if not FreeCAD.getActiveTransaction():
        doc.openTransaction(name)


@contextmanager
def transaction(doc, name, commit=True):
    """One step of undo, taken back when an exception comes; without commit a panel that was opened ends it."""
    doc.openTransaction(name)
    try:
        yield
    except Exception:
        doc.abortTransaction()
        raise
    if commit:
        doc.commitTransaction()


def record(*lines):
    """Run lines of Python, and write them to the macro that is being recorded."""
    FreeCADGui.addModule("FreeCAD")
    FreeCADGui.addModule("anisoquad")
    for line in lines:
        FreeCADGui.doCommand(line)


def reference(obj):
    """How a macro names a document object."""
    return f"FreeCAD.ActiveDocument.{obj.Name}"


def newest(doc):
    """The object that was added last."""
    return doc.Objects[-1]
