"""Quads of eight nodes: a node in the middle of every edge, on the surface."""

from dataclasses import dataclass

import numpy as np

from .surface_lines import SurfaceLines, edges_of


@dataclass(frozen=True)
class SecondOrder:
    """The second-order form of a QuadMesh with P points, E edges and Q quads.

    points -- (P+E,3) float64: the mesh's points, then the mid-side nodes
    quads  -- (Q,8) int32: corners a, b, c, d, then the middles of ab, bc, cd, da
    """

    points: np.ndarray
    quads: np.ndarray

    def with_middles(self, edges):
        """(n,3) int32: the ends and the mid-side node of (n,2) edges of the mesh."""
        sides, middle = _sides(self.quads[:, :4]), self.quads[:, 4:].ravel()
        size = len(self.points)
        keys, first = np.unique(np.sort(sides, axis=1) @ [size, 1], return_index=True)
        place = np.searchsorted(keys, np.sort(edges.astype(np.int64), axis=1) @ [size, 1])
        return np.column_stack([edges, middle[first[place]]]).astype(np.int32)


def second_order(mesh, points, triangles, feature_angle, lines=(), surface=None):
    """The SecondOrder of a QuadMesh, its mid-side nodes on the triangulated surface, those of feature edges on feature lines.

    points, triangles, feature_angle -- the surface (N,3), (M,3), and degrees, as given for the mesh
    lines -- paths of point ids that are feature lines too: sources and feature edges
    surface -- the CadSurface of the mesh: the mid-side nodes are put onto that instead
    """
    ends, first, index = np.unique(np.sort(_sides(mesh.quads), axis=1), axis=0, return_index=True, return_inverse=True)
    size = len(mesh.points)
    line_keys = np.sort(mesh.line_edges[:, :2].astype(np.int64), axis=1) @ [size, 1]
    on_line = np.isin(ends @ [size, 1], line_keys)
    middles = 0.5 * (mesh.points[ends[:, 0]] + mesh.points[ends[:, 1]])
    if surface is None:
        middles = SurfaceLines(points, triangles, feature_angle, edges_of(lines)).onto_surface(middles, on_line)
    else:
        middles = surface.project(middles, mesh.quad_facet[first // 4], _input_edges(mesh, ends, on_line, line_keys))
    quads = np.column_stack([mesh.quads, index.reshape(-1, 4) + size]).astype(np.int32)
    return SecondOrder(np.concatenate([mesh.points, middles]), quads)


def _input_edges(mesh, ends, on_line, line_keys):
    """(n,2): for edges of the mesh on feature lines the input's edge near them, for others (-1, -1). line_keys -- of mesh.line_edges"""
    order = np.argsort(line_keys)
    found = np.full((len(ends), 2), -1)
    place = np.searchsorted(line_keys[order], ends[on_line] @ [len(mesh.points), 1])
    found[on_line] = mesh.line_edge_input[order[place]]
    return found


def _sides(quads):
    """(4Q,2) int64: the edges ab, bc, cd, da of each quad."""
    return np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2).astype(np.int64)
