"""The mesh that comes out."""

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class QuadMesh:
    """An all-quad mesh; P points, Q quads, E edges on feature lines. Units are those of the input.

    points     -- (P,3) float64
    quads      -- (Q,4) int32, oriented as the input
    row        -- (Q,) int32: 1-based row from its source, 0 = not in a row
    pass_      -- (Q,) int32: 1-based pass that built the row, 0 = not in a row
    source     -- (Q,) int32: index of the source, -1 = none
    patch      -- (Q,) int32: index of the patch
    node_line  -- (P,) int32: feature line that the point lies on, -1 = none
    node_input -- (P,) int32: input point that it is, -1 = a new or moved point
    line_edges -- (E,3) int32: (point, point, line); covers every boundary and feature line of the input
    Of a mesh on a CAD surface, else empty:
    quad_facet -- (Q,) int32: input triangle below the quad's middle
    line_edge_input -- (E,2) int32: the input edge near each line edge, as two input points
    cad_face   -- (Q,) int32: CAD face of the quad, Face1 is 0
    cad_edge   -- (E,) int32: CAD edge on which the line edge lies, Edge1 is 0; -1 = none
    report     -- dict of counts, rows, quality, times and warnings; JSON-serialisable
    stages     -- [(name, points, faces (F,4) with -1 as a triangle's fourth, row (F,)), ...] if Options.record_stages
    """

    points: np.ndarray
    quads: np.ndarray
    row: np.ndarray
    pass_: np.ndarray
    source: np.ndarray
    patch: np.ndarray
    node_line: np.ndarray
    node_input: np.ndarray
    line_edges: np.ndarray
    report: dict
    stages: list = field(default_factory=list)
    quad_facet: np.ndarray = field(default_factory=lambda: np.empty(0, np.int32))
    line_edge_input: np.ndarray = field(default_factory=lambda: np.empty((0, 2), np.int32))
    cad_face: np.ndarray = field(default_factory=lambda: np.empty(0, np.int32))
    cad_edge: np.ndarray = field(default_factory=lambda: np.empty(0, np.int32))

    @property
    def valid(self):
        """True when the mesh is all quads and none is inverted."""
        return self.report["triangles_left"] == 0 and self.report["inverted"] == 0 and len(self.quads) > 0
