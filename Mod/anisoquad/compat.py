"""The one place for differences between FreeCAD's versions: written for 0.20 to 1.1."""

import weakref
from functools import partial
from importlib import import_module


def global_placement(obj):
    """The placement of a document object in the world, also inside an App::Part."""
    if hasattr(obj, "getGlobalPlacement"):
        return obj.getGlobalPlacement()
    return obj.Placement


def qt_widgets():
    """The module of Qt's widgets: a part of QtGui up to FreeCAD 0.20."""
    try:
        from PySide import QtWidgets
    except ImportError:
        from PySide import QtGui as QtWidgets
    return QtWidgets


def load_ui(path):
    """The widget that a .ui file describes."""
    import FreeCADGui

    form = FreeCADGui.PySideUic.loadUi(path)
    form.destroyed.connect(partial(_forget, weakref.ref(form)))
    return form


def _forget(form, *_):
    """Part the Python object of a deleted widget from its address.

    PySide does so for the widgets that it made itself, not for the one that FreeCAD's loader hands out. Whoever found that one with
    findChild keeps its Python object alive, and the next widget at that address, of whatever type, would be taken for it.
    """
    if form() is not None:
        _shiboken().invalidate(form())


def _shiboken():
    """The module with which PySide ties Python objects to those of C++."""
    from PySide.QtCore import QObject

    return import_module("shiboken" + QObject.__module__.removeprefix("PySide").split(".")[0])


def translate(context, text):
    """The text in the user's language."""
    import FreeCAD

    if hasattr(FreeCAD, "Qt"):
        return FreeCAD.Qt.translate(context, text)
    from PySide import QtCore

    return QtCore.QCoreApplication.translate(context, text)


def button_box(*names):
    """Standard buttons of a task panel, as getStandardButtons() has to return them: an int before FreeCAD 1.0, a flag later."""
    import FreeCAD

    box = qt_widgets().QDialogButtonBox
    buttons = getattr(box, names[0])
    for name in names[1:]:
        buttons = buttons | getattr(box, name)
    return _number(buttons) if FreeCAD.Version()[0] == "0" else buttons


def button_name(button):
    """Name of the standard button that a task panel's clicked() got, or an empty text."""
    box = qt_widgets().QDialogButtonBox
    return next((name for name in ("Ok", "Apply", "Cancel", "Close") if _number(getattr(box, name)) == _number(button)), "")


def _number(flag):
    """Flags of PySide6 are enumerations, older ones convert by themselves."""
    return int(getattr(flag, "value", flag))


def is_shape(obj):
    """True for an object with a CAD shape."""
    return obj.isDerivedFrom("Part::Feature")
