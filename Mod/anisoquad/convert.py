"""FreeCAD's meshes to numpy and back. No GUI."""

import os
import tempfile
import zlib

import Fem
import numpy as np

from . import _core
from .groups import face_groups, line_groups

# A .bms file of FreeCAD: a header with the counts, then points (3 float32), then facets (3 points, 3 neighbours; uint32).
_COUNTS_AT = 264
_POINTS_AT = 272


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


def mesh_to_arrays(mesh, placement=None):
    """(points (N,3) float64, triangles (M,3) int32) of a Mesh.Mesh, its points moved by the placement."""
    data = bms_bytes(mesh)
    point_count, facet_count = np.frombuffer(data, np.uint32, 2, _COUNTS_AT).tolist()
    points = np.frombuffer(data, np.float32, 3 * point_count, _POINTS_AT).reshape(-1, 3).astype(np.float64)
    facets = np.frombuffer(data, np.uint32, 6 * facet_count, _POINTS_AT + 12 * point_count).reshape(-1, 6)
    if placement is not None and not placement.isIdentity():
        matrix = np.array(placement.Matrix.A).reshape(4, 4)
        points = points @ matrix[:3, :3].T + matrix[:3, 3]
    return points, facets[:, :3].astype(np.int32)


def signature(mesh, placement):
    """A short text that differs when the mesh or where it stands does."""
    matrix = " ".join(f"{value:.17g}" for value in placement.Matrix.A)
    return f"{mesh.CountPoints} {mesh.CountFacets} {zlib.crc32(bms_bytes(mesh)[_POINTS_AT:]):08x} {zlib.crc32(matrix.encode()):08x}"


def fem_mesh_of(mesh):
    """A Fem.FemMesh of a QuadMesh: ids from 1 in the same order; face groups per patch and pass, node groups per line."""
    fem_mesh = Fem.FemMesh()
    _core.fill_fem_mesh(fem_mesh, mesh.points, mesh.quads)
    for name, faces in face_groups(mesh).items():
        _add_group(fem_mesh, name, "Face", faces)
    for name, edges in line_groups(mesh).items():
        _add_group(fem_mesh, name, "Node", np.unique(edges))
    return fem_mesh


def _add_group(fem_mesh, name, kind, indices):
    group = fem_mesh.addGroup(name, kind)
    fem_mesh.addGroupElements(group, (indices + 1).tolist())
