"""The scripting API in FreeCAD. No GUI."""

from .errors import MeshError
from .objects.quad_mesh_object import QuadMeshObject
from .objects.source_text import to_text
from .source import format_passes


def make_quad_mesh(doc, base=None, sources=(), passes=None, anisotropy=None, options=None, name="QuadMesh"):
    """Add a quad mesh object to a document; it is filled at the next doc.recompute().

    base       -- the Mesh::Feature to mesh
    sources    -- lists of 0-based point ids of the base mesh, or anisoquad.Source objects (with passes of their own or not)
    passes     -- for all sources without passes of their own: [4, 2, 2], [(4, 6), 2] with rows, or text "4:6, 2"
    anisotropy -- instead of passes: the maximum anisotropy
    options    -- anisoquad.Options, kept as properties of the object
    Returns the Fem::FemMeshObjectPython. Raises MeshError when sources or passes can not be read.
    """
    if passes is not None and anisotropy is not None:
        raise MeshError("Give either the passes or the anisotropy, not both.", code="invalid_option")
    passes_text = format_passes(passes or [])
    source_texts = [to_text(source) for source in sources]
    obj = doc.addObject("Fem::FemMeshObjectPython", name)
    proxy = QuadMeshObject(obj)
    obj.Base = base
    obj.Passes = passes_text
    obj.Anisotropy = 1 if anisotropy is None else anisotropy
    obj.Sources = source_texts
    if options is not None:
        proxy.set_options(obj, options)
    return obj
