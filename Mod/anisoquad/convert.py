"""FreeCAD's meshes to numpy and back. No GUI."""

import os
import tempfile
import time
import zlib

import Fem
import numpy as np

from . import _core
from .groups import face_groups, line_groups

# A .bms file of FreeCAD: a header with the counts, then points (3 float32), then facets (3 points, 3 neighbours; uint32).
_COUNTS_AT = 264
_POINTS_AT = 272

_AT_ONCE = 30_000  # elements of a group: some hundredths of a second in which no other thread runs
_NAP = 0.005  # seconds after each, in which the window does what it has to; in a bare gap between two calls no other thread wakes


def bms_bytes(mesh):
    """A Mesh.Mesh in FreeCAD's own binary format: exact, without its Placement. A fifth of the time of .Topology."""
    handle, path = tempfile.mkstemp(suffix=".bms")
    os.close(handle)
    try:
        mesh.write(Filename=path, Format="BMS")
        with open(path, "rb") as file:
            return file.read()
    finally:
        os.unlink(path)


def mesh_content(mesh):
    """(points (N,3) float64, triangles (M,3) int32, signature) of a Mesh.Mesh, in its own coordinates.

    The signature is a short text that differs when the points or facets do.
    """
    data = memoryview(bms_bytes(mesh))
    point_count, facet_count = np.frombuffer(data, np.uint32, 2, _COUNTS_AT).tolist()
    points = np.frombuffer(data, np.float32, 3 * point_count, _POINTS_AT).reshape(-1, 3).astype(np.float64)
    facets = np.frombuffer(data, np.uint32, 6 * facet_count, _POINTS_AT + 12 * point_count).reshape(-1, 6)
    signature = f"{point_count} {facet_count} {zlib.crc32(data[_POINTS_AT:]):08x}"
    return points, facets[:, :3].astype(np.int32), signature


def mesh_of(points, triangles):
    """A Mesh.Mesh of points (N,3) and triangles (M,3)."""
    import Mesh

    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = np.empty(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    handle, path = tempfile.mkstemp(suffix=".ply")
    try:
        with open(handle, "wb") as file:
            file.write(header.encode() + np.asarray(points, "<f4").tobytes() + faces.tobytes())
        return Mesh.Mesh(path)
    finally:
        os.unlink(path)


def moved(points, placement):
    """Points (N,3) moved by a placement."""
    if placement.isIdentity():
        return points
    matrix = np.array(placement.Matrix.A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def placement_signature(placement):
    """A short text that differs when the placement does."""
    return f"{zlib.crc32(' '.join(f'{value:.17g}' for value in placement.Matrix.A).encode()):08x}"


def fem_mesh_of(mesh, second_order=None, source_nodes=()):
    """A Fem.FemMesh of a QuadMesh: ids from 1 in the same order.

    second_order -- the mesh's SecondOrder: quads of eight nodes, the mid-side nodes after the corners
    source_nodes -- for each source the ids of its nodes, as source_nodes() gives them
    Face groups per patch and pass, node groups per feature line and source.
    """
    fem_mesh = Fem.FemMesh()
    form = mesh if second_order is None else second_order
    _core.fill_fem_mesh(fem_mesh, form.points, form.quads)
    for name, faces in face_groups(mesh).items():
        _add_group(fem_mesh, name, "Face", faces)
    for name, edges in line_groups(mesh).items():
        edges = edges if second_order is None else second_order.with_middles(edges)
        _add_group(fem_mesh, name, "Node", np.unique(edges))
    for index, nodes in enumerate(source_nodes):
        if len(nodes):
            _add_group(fem_mesh, f"Source_{index + 1}", "Node", nodes)
    return fem_mesh


def source_nodes(mesh, sources, points):
    """For each source the ids of the mesh's nodes on it: nodes of feature lines that lie on the source's polyline, or near its
    edges where a CAD surface was given.

    points -- (N,3): those that the sources' vertex ids count
    """
    on_lines = np.flatnonzero(mesh.node_line >= 0)
    tolerance = 1e-6 * np.linalg.norm(np.ptp(points, axis=0))
    found = []
    for source in sources:
        line = points[source.vertices]
        distance = np.full(len(on_lines), np.inf)
        for start, end in zip(line[:-1], line[1:]):
            distance = np.minimum(distance, _distance_to_segment(mesh.points[on_lines], start, end))
        nodes = on_lines[distance <= tolerance]
        found.append(np.union1d(nodes, _nodes_near(mesh, source.vertices)).astype(int))
    return found


def _nodes_near(mesh, path):
    """Ids of the ends of line edges that are near the input's edges of a path."""
    if not len(mesh.line_edge_input):
        return np.empty(0, int)
    pairs = {frozenset(pair) for pair in zip(path[:-1], path[1:])}
    near = [frozenset(pair) in pairs for pair in mesh.line_edge_input.tolist()]
    return mesh.line_edges[np.array(near, bool), :2].ravel()


def fem_mesh_to_arrays(fem_mesh):
    """(points (P,3) float64, quads (Q,4) or (Q,8) int32) of a FemMesh that fem_mesh_of() made."""
    nodes = fem_mesh.Nodes
    points = np.array([tuple(nodes[node]) for node in range(1, len(nodes) + 1)], float).reshape(-1, 3)
    quads = np.array([fem_mesh.getElementNodes(face) for face in range(1, fem_mesh.FaceCount + 1)], np.int32)
    return points, quads.reshape(-1, quads.shape[1] if quads.size else 4) - 1


def _distance_to_segment(points, start, end):
    along = end - start
    place = np.clip((points - start) @ along / max(along @ along, 1e-300), 0.0, 1.0)
    return np.linalg.norm(points - start - place[:, None] * along, axis=1)


def _add_group(fem_mesh, name, kind, indices):
    group = fem_mesh.addGroup(name, kind)
    ids = np.asarray(indices) + 1
    for start in range(0, len(ids), _AT_ONCE):
        if start:
            time.sleep(_NAP)
        fem_mesh.addGroupElements(group, ids[start : start + _AT_ONCE].tolist())
