"""What view providers share whose objects are edited in a task panel."""

import FreeCADGui


class EditedInPanel:
    """A double click opens the panel that the view provider's `make_panel(obj)` gives."""

    def doubleClicked(self, view):
        FreeCADGui.ActiveDocument.setEdit(view.Object.Name)
        return True

    def setEdit(self, view, mode):
        if mode != 0:
            return None
        FreeCADGui.Control.showDialog(self.make_panel(view.Object))
        return True

    def unsetEdit(self, view, mode):
        if mode != 0:
            return None
        FreeCADGui.Control.closeDialog()
        return True
