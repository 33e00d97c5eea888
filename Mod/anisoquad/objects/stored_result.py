"""What a FemMesh can not keep of a quad mesh, as text for a property: rows, passes, sources, patches, lines."""

import base64
import io
import json
import zlib

import numpy as np

from ..quad_mesh_result import QuadMesh

_ARRAYS = ("row", "pass_", "source", "patch", "node_line", "node_input", "line_edges")
_CAD_ARRAYS = ("quad_facet", "line_edge_input", "cad_face", "cad_edge")  # files of older versions have none

_BASE64 = "base64:"  # files of older versions hold base 85, which Python makes in a loop: at a million triangles half a second


def pack(mesh):
    """The text of a QuadMesh without its points and quads."""
    buffer = io.BytesIO()
    np.savez(buffer, **{name: getattr(mesh, name) for name in _ARRAYS + _CAD_ARRAYS})
    return _BASE64 + base64.b64encode(zlib.compress(buffer.getvalue(), 6)).decode("ascii")


def unpack(text, points, quads, report_text):
    """The QuadMesh again.

    points -- (P,3) float64 and quads -- (Q,4) int32, in the order in which they were packed; report_text -- JSON
    """
    data = base64.b64decode(text[len(_BASE64) :]) if text.startswith(_BASE64) else base64.b85decode(text)
    arrays = np.load(io.BytesIO(zlib.decompress(data)), allow_pickle=False)
    return QuadMesh(points=points, quads=quads, report=json.loads(report_text), **{name: arrays[name] for name in _ARRAYS + _CAD_ARRAYS if name in arrays})
