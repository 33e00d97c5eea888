"""The base meshes of quad meshes and sources as arrays. All ask for them, and FreeCAD does so to draw its tree: each is read once."""

import FreeCAD

from .. import convert
from ..compat import global_placement

_contents = {}  # (document, object) -> _Content of the mesh, forgotten at every change
_observers = []


class _Content:
    """What is known of a mesh: arrays in its own coordinates, its signature, and (signature of a placement, points moved by it)."""

    def __init__(self, mesh):
        points, triangles, self.signature = convert.mesh_content(mesh)
        self.points, self.triangles = _read_only(points), _read_only(triangles)
        self.moved = None, None


def base_arrays(base):
    """(points (N,3) float64, triangles (M,3) int32) of a mesh object in world coordinates; not to be written to."""
    content, placement = _content(base), global_placement(base)
    signature = convert.placement_signature(placement)
    if content.moved[0] != signature:
        content.moved = signature, _read_only(convert.moved(content.points, placement))
    return content.moved[1], content.triangles


def base_signature(base):
    """A short text that differs when the mesh object's mesh, or where it stands, does."""
    return f"{_content(base).signature} {convert.placement_signature(global_placement(base))}"


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


def _content(base):
    if not _observers:
        _observers.append(MeshObserver())
        FreeCAD.addDocumentObserver(_observers[0])
    key = base.Document.Name, base.Name
    if key not in _contents:
        _contents[key] = _Content(base.Mesh)
    return _contents[key]


def _read_only(array):
    array.setflags(write=False)
    return array
