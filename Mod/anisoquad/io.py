"""Triangles from files, quad meshes to files. No FreeCAD."""

import re
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

import numpy as np

from .errors import MeshError
from .groups import face_groups, line_groups
from .polygons import split_polygons
from .quality import scaled_jacobian


def read_triangles(path):
    """(points (N,3) float64, triangles (M,3) int32) of a .stl, .obj, .off or .ply file.

    The points keep the file's order; those of an .stl are welded where equal, in the order in which they appear.
    Raises MeshError ("unreadable_file") when the file can not be read, or holds facets that are not triangles.
    """
    points, facets = _read(Path(path))
    for index, facet in enumerate(facets if isinstance(facets, list) else ()):
        if len(facet) != 3:
            raise MeshError(f"{path}: facet {index} has {len(facet)} corners; only triangles can be meshed, a repair splits others",
                            code="unreadable_file", kind="facet", ids=[index])
    return points, _as_triangles(facets)


def read_and_split(path):
    """(points, triangles, number of facets with more corners that were split) of a file, see read_triangles()."""
    points, facets = _read(Path(path))
    try:
        triangles, split = split_polygons(points, facets) if isinstance(facets, list) else (facets, 0)
    except ValueError as error:
        raise _unreadable(path, str(error)) from None
    return points, _as_triangles(triangles), split


def _as_triangles(facets):
    # What int32 can't hold is out of range at its limits too: the core names the facets.
    triangles = np.clip(np.array(facets, np.int64).reshape(-1, 3), np.iinfo(np.int32).min, np.iinfo(np.int32).max)
    return np.ascontiguousarray(triangles, np.int32)


def _read(path):
    """(points (N,3) float64, facets: an (M,3) array or lists of ids)."""
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise _unreadable(path, f"can only read {', '.join(_READERS)}")
    try:
        points, facets = reader(path)
        if isinstance(facets, list):
            np.array([id_ for facet in facets for id_ in facet], np.int64)  # whole numbers that it can hold
    except OSError as error:
        raise _unreadable(path, error.strerror or str(error)) from None
    except MeshError:
        raise
    except (Exception, SystemExit) as error:  # meshio ends with many types of exception, and some readers of it exit
        raise _unreadable(path, f"not a valid {path.suffix[1:].upper()} file ({_first_line(error)})") from None
    return np.ascontiguousarray(points, np.float64), facets


def writable(path):
    """True when write_mesh knows the format."""
    return Path(path).suffix.lower() in _WRITERS


def write_mesh(path, mesh, second_order=None):
    """Write a QuadMesh as .vtu, .inp (CalculiX, Abaqus: S4, S8), .msh (Gmsh 2.2), .su2 or .obj. Raises MeshError.

    second_order -- the mesh's SecondOrder; .su2 and .obj have no such quads, and get the corners
    """
    path = Path(path)
    if not writable(path):
        raise MeshError(f"{path}: can only write {', '.join(_WRITERS)}", code="unwritable_file")
    try:
        _WRITERS[path.suffix.lower()](path, mesh, second_order)
    except OSError as error:
        raise MeshError(f"{path}: {error.strerror or error}", code="unwritable_file") from None


def _unreadable(path, reason):
    return MeshError(f"{path}: {reason}", code="unreadable_file")


def _first_line(error):
    return (str(error).strip() or type(error).__name__).splitlines()[0]


def _read_off(path):
    lines = [line for line in (raw.split("#", 1)[0].split() for raw in path.read_text(errors="replace").splitlines()) if line]
    if not lines or not re.fullmatch("(ST)?C?N?OFF", lines[0][0]):  # what these letters add follows the coordinates
        raise ValueError("it does not begin with OFF")
    first = lines.pop(0)[1:]
    counts = first or lines.pop(0)
    points, facets = int(counts[0]), int(counts[1])
    if points < 0 or facets < 0 or len(lines) < points + facets:
        raise ValueError(f"it ends before its {points} points and {facets} facets")
    return np.array([line[:3] for line in lines[:points]], float).reshape(-1, 3), [
        [int(id_) for id_ in line[1 : 1 + int(line[0])]] for line in lines[points : points + facets]
    ]


def _read_obj(path):
    points, facets = [], []
    for raw in path.read_text(errors="replace").splitlines():
        fields = raw.split()
        if not fields:
            continue
        if fields[0] == "v":
            points.append(fields[1:4])
        elif fields[0] == "f":
            ids = [int(field.split("/", 1)[0]) for field in fields[1:]]
            facets.append([id_ - 1 if id_ > 0 else len(points) + id_ for id_ in ids])
    return np.array(points, float).reshape(-1, 3), facets


def _read_by_meshio(path):
    import meshio

    if path.stat().st_size == 0:
        raise ValueError("it is empty")
    said = StringIO()
    try:
        with redirect_stdout(said), redirect_stderr(said):  # it prints why it ends
            mesh = meshio.read(path)
    except SystemExit:
        raise ValueError(_first_line(said.getvalue())) from None
    except KeyError as error:
        raise ValueError(f"it holds data that can't be read: {error}") from None
    if len(mesh.cells) == 1 and mesh.cells[0].type == "triangle":
        return mesh.points[:, :3], mesh.cells[0].data
    facets = [facet for cells in mesh.cells if cells.type not in ("vertex", "line") for facet in np.asarray(cells.data).tolist()]
    return mesh.points[:, :3], facets


def _read_stl(path):
    with path.open("rb") as file:
        count = np.frombuffer(file.read(84)[80:], "<u4")
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    if count.size == 0 or path.stat().st_size != 84 + int(count[0]) * facet.itemsize:
        return _read_by_meshio(path)  # text, or broken
    corners = np.fromfile(path, facet, offset=84)["corners"].reshape(-1, 3)
    _, first, ids = np.unique(corners, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return corners[first[order]], rank[ids.reshape(-1, 3)]


def _elements(mesh, second_order):
    """(points, quads (Q,4) or (Q,8)) that are written."""
    return (mesh.points, mesh.quads) if second_order is None else (second_order.points, second_order.quads)


def _line_nodes(edges, second_order):
    """(n,2) or (n,3): ends, and middles where there are some."""
    return edges if second_order is None else second_order.with_middles(edges)


def _write_by_meshio(path, mesh, second_order, lines, cell_data, point_data=None, **how):
    import meshio

    points, quads = _elements(mesh, second_order)
    quad, line = ("quad", "line") if second_order is None else ("quad8", "line3")
    cells = [(quad, quads)] + [(line, _line_nodes(edges, second_order)) for edges in lines]
    meshio.Mesh(points, cells, cell_data=cell_data, point_data=point_data).write(path, **how)


def _write_vtu(path, mesh, second_order):
    data = {"row": mesh.row, "pass": mesh.pass_, "source": mesh.source, "patch": mesh.patch,
            "scaled_jacobian": scaled_jacobian(mesh.points, mesh.quads)}
    middles = len(_elements(mesh, second_order)[0]) - len(mesh.points)
    of_points = {name: np.pad(values, (0, middles), constant_values=-1)
                 for name, values in (("line", mesh.node_line), ("input", mesh.node_input))}
    _write_by_meshio(path, mesh, second_order, [], {name: [values] for name, values in data.items()}, of_points)


def _write_msh(path, mesh, second_order):
    lines = line_groups(mesh)
    physical = [mesh.patch + 1] + [np.full(len(edges), index + 1, np.int32) for index, edges in enumerate(lines.values())]
    _write_by_meshio(path, mesh, second_order, lines.values(), {"gmsh:physical": physical, "gmsh:geometrical": physical},
                     file_format="gmsh22", binary=False)


def _write_inp(path, mesh, second_order):
    points, quads = _elements(mesh, second_order)
    with path.open("w", encoding="ascii") as out:
        out.write("** Written by AnisoQuad\n*NODE, NSET=Nall\n")
        _write_rows(out, "{},{!r},{!r},{!r}\n", np.arange(1, len(points) + 1), points)
        out.write(f"*ELEMENT, TYPE=S{quads.shape[1]}, ELSET=Eall\n")
        _write_rows(out, ",".join(["{}"] * (quads.shape[1] + 1)) + "\n", np.arange(1, len(quads) + 1), quads + 1)
        for name, faces in face_groups(mesh).items():
            _write_set(out, "ELSET", name, faces + 1)
        for name, edges in line_groups(mesh).items():
            _write_set(out, "NSET", name, np.unique(_line_nodes(edges, second_order)) + 1)


def _write_set(out, keyword, name, ids):
    out.write(f"*{keyword}, {keyword}={name}\n")
    for start in range(0, len(ids), 16):
        out.write(",".join(map(str, ids[start : start + 16].tolist())) + ",\n")


def _write_su2(path, mesh, _):
    with path.open("w", encoding="ascii") as out:
        out.write(f"NDIME= 3\nNELEM= {len(mesh.quads)}\n")
        _write_rows(out, "9 {1} {2} {3} {4} {0}\n", np.arange(len(mesh.quads)), mesh.quads)
        out.write(f"NPOIN= {len(mesh.points)}\n")
        _write_rows(out, "{1!r} {2!r} {3!r} {0}\n", np.arange(len(mesh.points)), mesh.points)
        lines = line_groups(mesh)
        out.write(f"NMARK= {len(lines)}\n")
        for name, edges in lines.items():
            out.write(f"MARKER_TAG= {name}\nMARKER_ELEMS= {len(edges)}\n")
            out.writelines(f"3 {a} {b}\n" for a, b in edges.tolist())


def _write_obj(path, mesh, _):
    with path.open("w", encoding="ascii") as out:
        out.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in mesh.points.tolist())
        out.writelines("f {} {} {} {}\n".format(*quad) for quad in (mesh.quads + 1).tolist())


def _write_rows(out, layout, ids, rows):
    out.writelines(layout.format(id_, *row) for id_, row in zip(ids.tolist(), rows.tolist()))


_READERS = {".stl": _read_stl, ".obj": _read_obj, ".off": _read_off, ".ply": _read_by_meshio}
_WRITERS = {".vtu": _write_vtu, ".inp": _write_inp, ".msh": _write_msh, ".su2": _write_su2, ".obj": _write_obj}
