"""The named sets of a quad mesh, the same in every format and in FreeCAD."""

import numpy as np


def face_groups(mesh):
    """{name: 0-based quad indices}: Patch_1 … for each patch, Source_1_Pass_1 … for the rows that a pass built, Face1 … of a CAD shape."""
    groups = {f"Patch_{patch + 1}": np.flatnonzero(mesh.patch == patch) for patch in np.unique(mesh.patch)}
    in_row = mesh.row > 0
    for source, pass_ in np.unique(np.column_stack([mesh.source[in_row], mesh.pass_[in_row]]), axis=0):
        members = in_row & (mesh.source == source) & (mesh.pass_ == pass_)
        groups[f"Source_{source + 1}_Pass_{pass_}"] = np.flatnonzero(members)
    groups.update({f"Face{face + 1}": np.flatnonzero(mesh.cad_face == face) for face in np.unique(mesh.cad_face)})
    return groups


def line_groups(mesh):
    """{name: (n,2) 0-based point indices}: the edges of each feature line, Line_1 …, and of each edge of a CAD shape, Edge1 …"""
    line = mesh.line_edges[:, 2]
    groups = {f"Line_{index + 1}": mesh.line_edges[line == index, :2] for index in np.unique(line)}
    groups.update({f"Edge{edge + 1}": mesh.line_edges[mesh.cad_edge == edge, :2] for edge in np.unique(mesh.cad_edge) if edge >= 0})
    return groups
