"""The one place for differences between FreeCAD's versions."""


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
