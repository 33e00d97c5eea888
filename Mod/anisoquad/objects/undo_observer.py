"""Undo and redo bring all properties of a quad mesh back but its FemMesh: this brings that too."""

import FreeCAD


class UndoObserver:
    """Document observer: after undo and redo, quad meshes whose run is still known take it up again, at once."""

    def slotUndoDocument(self, doc):
        self._refresh(doc)

    def slotRedoDocument(self, doc):
        self._refresh(doc)

    @staticmethod
    def _refresh(doc):
        for obj in doc.Objects:
            if hasattr(obj, "Proxy") and hasattr(obj.Proxy, "knows_run") and obj.Proxy.knows_run(obj):
                obj.touch()
                obj.recompute()


_observers = []


def observe():
    """Begin to observe documents; once a session."""
    if not _observers:
        _observers.append(UndoObserver())
        FreeCAD.addDocumentObserver(_observers[0])
