"""Helpers for the properties of document objects."""

from ..translation import QT_TRANSLATE_NOOP

VERSION_DOC = QT_TRANSLATE_NOOP("App::Property", "Version of these properties")


def add(obj, type_, name, group, doc, read_only=False):
    """Add a property where it is missing, so that objects of older files get the newer ones. True when it was added.

    doc -- in English; FreeCAD shows it translated in the context App::Property
    """
    if name in obj.PropertiesList:
        return False
    obj.addProperty(type_, name, group, doc, 1 if read_only else 0)
    return True


def hide(obj, *names):
    """Keep properties out of the property editor."""
    for name in names:
        obj.setEditorMode(name, 2)


def is_kind(obj, proxy_type):
    """True when the document object has a proxy of this class."""
    return obj is not None and isinstance(getattr(obj, "Proxy", None), proxy_type)


class SavedByProperties:
    """A proxy whose state is all in its object's properties. Older FreeCAD calls __getstate__, newer dumps."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
