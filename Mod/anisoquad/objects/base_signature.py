"""Tells whether a triangle mesh has changed. FreeCAD asks often, also to draw its tree, so the mesh is read only when it did."""

from .. import convert
from ..compat import global_placement

_contents = {}  # (document, object) -> signature of the mesh, forgotten at every change


def base_signature(base):
    """A short text that differs when the mesh object's mesh, or where it stands, does."""
    key = base.Document.Name, base.Name
    if key not in _contents:
        _contents[key] = convert.mesh_signature(base.Mesh)
    return f"{_contents[key]} {convert.placement_signature(global_placement(base))}"


class MeshObserver:
    """Document observer: forgets what is known of meshes that changed or went."""

    def slotChangedObject(self, obj, property_):
        if property_ == "Mesh":
            _contents.pop((obj.Document.Name, obj.Name), None)

    def slotDeletedObject(self, obj):
        _contents.pop((obj.Document.Name, obj.Name), None)

    def slotDeletedDocument(self, doc):
        for key in [key for key in _contents if key[0] == doc.Name]:
            del _contents[key]
