"""The scripting API in FreeCAD. No GUI."""

from .compat import is_shape
from .errors import MeshError
from .io import write_mesh
from .meshing import Options
from .objects.option_properties import set_options
from .objects.quad_mesh_object import QuadMeshObject, result_of, second_order_of
from .objects.source_object import SourceObject, is_source
from .objects.triangles_object import TRIANGULATORS, TrianglesObject, triangles_of
from .source import Source, format_passes, parse_passes


def make_quad_mesh(doc, base=None, sources=(), passes=None, anisotropy=None, options=None, element_order=1, smooth_angle=0.0,
                   triangulator=None, name="QuadMesh"):
    """Add a quad mesh object to a document; it is filled at the next doc.recompute().

    base          -- the Mesh::Feature to mesh, or a Part object: it is triangulated (make_triangles, found again where it has been),
                     patches are its faces, and all nodes lie exactly on it
    sources       -- source objects, or lists of 0-based point ids of the base mesh, or anisoquad.Source objects, of which
                     source objects are made; of a Part object edges too: "Edge3", ["Edge3", "Edge5"], (object or its name, "Edge3")
    passes        -- for the sources that have none of their own: [4, 2, 2], [(4, 6), 2] with rows, or text "4:6, 2"
    anisotropy    -- instead of passes: the maximum anisotropy
    options       -- anisoquad.Options, kept as properties of the object
    element_order -- 1, or 2 for quads of eight nodes
    smooth_angle  -- degrees; faces of a Part object whose normals differ by less where they meet are one patch
    triangulator  -- of a Part object: "OpenCASCADE", or "Gmsh", which takes the size and curvature angle of the options; None: as
                     the triangles have it, OpenCASCADE where there are none yet
    Returns the Fem::FemMeshObjectPython. Raises MeshError when sources or passes can not be read.
    """
    how = _how(passes, anisotropy)
    if triangulator is not None:
        _check_triangulator(triangulator)
        if base is None or not is_shape(base):
            raise MeshError("The triangulator is that of a Part object, which the base is not.", code="invalid_option")
    sources = [_read_source(doc, base, source) for source in sources]
    if base is not None and is_shape(base):
        base = triangles_of(base) or make_triangles(doc, base, name=f"{base.Name}Triangles")
        if triangulator is not None:
            _set_triangulator(base, triangulator, options or Options())
    obj = doc.addObject("Fem::FemMeshObjectPython", name)
    QuadMeshObject(obj)
    obj.Base = base
    obj.ElementOrder = _element_order(element_order)
    obj.SmoothAngle = smooth_angle
    if options is not None:
        set_options(obj, options)
    obj.Sources = [source if is_source(source) else _make_source_like(doc, base, source, how) for source in sources]
    return obj


def make_source(doc, base, vertices=(), edges=None, passes=None, anisotropy=None, sides="both", imprint=False, name="Source"):
    """Add a line source of anisotropy to a document.

    base       -- the Mesh::Feature on which it lies
    vertices   -- 0-based point ids of the base mesh, neighbours joined by mesh edges; closed when the first is also the last
    edges      -- instead of vertices: (Part object, ["Edge1", …]); the mesh edges on them become the source
    passes, anisotropy -- as in make_quad_mesh; with neither the line is a feature without rows
    sides      -- "both", "left" or "right" of the line, seen along it with the surface's normal up
    imprint    -- straighten the line into the triangles before rows start
    Returns the App::FeaturePython. Raises MeshError when passes or sides can not be read.
    """
    how = _how(passes, anisotropy)
    source = Source(vertices, sides=sides)
    obj = doc.addObject("App::FeaturePython", name)
    SourceObject(obj)
    obj.Base = base
    obj.Vertices = source.vertices
    if edges is not None:
        obj.Edges = edges
    for property_, value in how.items():
        setattr(obj, property_, value)
    obj.Sides = sides
    obj.Imprint = imprint
    return obj


def make_triangles(doc, shape, deflection=0.0, max_length=0.0, triangulator="OpenCASCADE", size=0.0, curvature_angle=30.0, name="Triangles"):
    """Add the tessellation of a Part object to a document, as the base of a quad mesh.

    deflection -- largest distance of the triangles from the shape; 0: a five-thousandth of the shape's diagonal
    max_length -- instead: triangles of good shape with edges up to this length, by Mefisto
    triangulator -- "OpenCASCADE", or "Gmsh", for which the next two are
    size            -- largest edge length; 0: a tenth of the shape's diagonal
    curvature_angle -- degrees that one edge may turn along the surface; 0: any
    Returns the Mesh::FeaturePython. Raises MeshError for another triangulator.
    """
    _check_triangulator(triangulator)
    obj = doc.addObject("Mesh::FeaturePython", name)
    TrianglesObject(obj)
    obj.Shape = shape
    obj.Deflection = deflection
    obj.MaxLength = max_length
    obj.Triangulator = triangulator
    obj.Size = size
    obj.CurvatureAngle = curvature_angle
    return obj


def export_quad_mesh(obj, path):
    """Write a quad mesh object as .vtu, .inp, .msh, .su2 or .obj. Raises MeshError when it is empty or can not be written."""
    mesh = result_of(obj)
    if mesh is None:
        raise MeshError(f"{obj.Label} holds no quads yet.", code="empty_mesh")
    write_mesh(path, mesh, second_order_of(obj))


def _how(passes, anisotropy):
    """{property of a source object: value} of passes or anisotropy."""
    if passes is not None and anisotropy is not None:
        raise MeshError("Give either the passes or the anisotropy, not both.", code="invalid_option")
    if anisotropy is not None:
        return {"Anisotropy": anisotropy}
    return {"Passes": format_passes(parse_passes(passes))} if passes else {}


def _check_triangulator(name):
    if name not in TRIANGULATORS:
        raise MeshError(f"The triangulator is {' or '.join(TRIANGULATORS)}, not {name!r}.", code="invalid_option")


def _set_triangulator(triangles, name, options):
    triangles.Triangulator = name
    if name == "Gmsh":
        triangles.Size, triangles.CurvatureAngle = options.size, options.curvature_angle


def _read_source(doc, base, source):
    """A source object, a Source, or (Part object, ["Edge1", …]) of what make_quad_mesh takes."""
    if is_source(source) or isinstance(source, Source):
        return source
    entries = [source] if isinstance(source, str) else list(source) if isinstance(source, (list, tuple)) else source
    if isinstance(entries, list) and len(entries) == 2 and not (isinstance(entries[0], str) and entries[0].startswith("Edge")):
        shape = doc.getObject(entries[0]) if isinstance(entries[0], str) else entries[0]
        names = [entries[1]] if isinstance(entries[1], str) else entries[1]
        if hasattr(shape, "Shape") and isinstance(names, (list, tuple)):
            return shape, _edge_names(names)
    if isinstance(entries, list) and entries and all(isinstance(entry, str) for entry in entries):
        if base is None or not is_shape(base):
            raise MeshError(f"The source {source!r} names edges of a Part object, which the base is not.", code="invalid_source")
        return base, _edge_names(entries)
    return Source(source)


def _edge_names(names):
    for name in names:
        if not (isinstance(name, str) and name.startswith("Edge") and name[4:].isdecimal()):
            raise MeshError(f"A source on a Part object is named like Edge3, not {name!r}.", code="invalid_source")
    return list(names)


def _make_source_like(doc, base, source, how):
    if isinstance(source, tuple):
        obj = make_source(doc, base, edges=source)
    else:
        obj = make_source(doc, base, source.vertices, sides=source.sides)
    if isinstance(source, Source) and source.passes:
        how = {"Passes": format_passes(source.passes)}
    for property_, value in how.items():
        setattr(obj, property_, value)
    return obj


def _element_order(order):
    if order not in (1, 2):
        raise MeshError(f"The element order is 1 or 2, not {order!r}.", code="invalid_option")
    return "1st" if order == 1 else "2nd"
