"""Pictures of quad meshes without a screen: a small z-buffer in numpy, so that hidden edges are hidden exactly."""

import struct
import zlib
from pathlib import Path

import numpy as np

_SAMPLES = 2  # rendered this many times larger in each direction, and averaged
_LINE = 1.1  # half the width of a mesh edge, in samples
_EDGE_COLOUR = np.array([0.10, 0.12, 0.18])
_SURFACE_COLOUR = np.array([0.86, 0.88, 0.92])
_PASS_COLOURS = np.array([[0.91, 0.35, 0.25], [0.96, 0.68, 0.22], [0.48, 0.74, 0.35], [0.25, 0.62, 0.80], [0.58, 0.44, 0.78]])


def row_colours(row, pass_):
    """(F,3) colours in 0…1: one hue a pass, every second row paler; grey where there is no row."""
    row, pass_ = np.asarray(row), np.asarray(pass_)
    hue = _PASS_COLOURS[(pass_ - 1) % len(_PASS_COLOURS)]
    colours = np.where((row % 2 == 0)[:, None], 0.65 * hue + 0.35, hue)
    return np.where((row > 0)[:, None], colours, _SURFACE_COLOUR)


def render(points, faces, colours, towards, up, centre, width, size):
    """A parallel view of a mesh.

    points  -- (P,3); faces -- (F,4), -1 as a triangle's fourth; colours -- (F,3) in 0…1
    towards -- direction from the surface to the eye; up -- direction that is up in the picture
    centre  -- point in the middle of the picture; width -- what it shows across, in the user's units
    size    -- (columns, lines) of the picture
    Returns (lines, columns, 3) uint8.
    """
    points = np.asarray(points, float)
    columns, lines = size[0] * _SAMPLES, size[1] * _SAMPLES
    eye = _unit(towards)
    right = _unit(np.cross(up, eye))
    axes = np.stack([right, -np.cross(eye, right), eye])
    scale = columns / width
    view = (points - np.asarray(centre, float)) @ axes.T * scale + [columns / 2, lines / 2, 0.0]

    image = np.ones((lines, columns, 3))
    depth = np.full((lines, columns), -np.inf)
    for face, colour in zip(faces, colours):
        corners = view[face[face >= 0]]
        if not _inside(corners, columns, lines):
            continue
        normal = np.cross(corners[2] - corners[0], corners[-1] - corners[1] if len(corners) == 4 else corners[1] - corners[0])
        shade = 0.45 + 0.55 * abs(normal[2]) / (np.linalg.norm(normal) or 1.0)
        if len(corners) == 3:
            _draw(image, depth, corners, (True, True, True), colour * shade)
        else:
            _draw(image, depth, corners[[0, 1, 2]], (True, True, False), colour * shade)
            _draw(image, depth, corners[[0, 2, 3]], (False, True, True), colour * shade)
    small = image.reshape(size[1], _SAMPLES, size[0], _SAMPLES, 3).mean(axis=(1, 3))
    return np.clip(small * 255 + 0.5, 0, 255).astype(np.uint8)


def save_png(path, image):
    """Write (lines, columns, 3) uint8 as a PNG file."""
    lines, columns, _ = image.shape
    raw = np.concatenate([np.zeros((lines, 1), np.uint8), image.reshape(lines, -1)], axis=1).tobytes()
    header = struct.pack(">IIBBBBB", columns, lines, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(raw, 6)), (b"IEND", b""))
    Path(path).write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + b"".join(struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data)) for tag, data in chunks)
    )


def _draw(image, depth, triangle, is_edge, colour):
    """One triangle into the z-buffer; is_edge says which of its sides 01, 12, 20 are edges of the mesh."""
    low = np.maximum(np.floor(triangle[:, :2].min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(triangle[:, :2].max(axis=0)).astype(int) + 1, [image.shape[1], image.shape[0]])
    if (high <= low).any():
        return
    x = np.arange(low[0], high[0])[None, :] + 0.5
    y = np.arange(low[1], high[1])[:, None] + 0.5
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = triangle
    double_area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if abs(double_area) < 1e-9:
        return
    weight_c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / double_area
    weight_a = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) / double_area
    weight_b = 1.0 - weight_a - weight_c
    z = weight_a * az + weight_b * bz + weight_c * cz
    region = (slice(low[1], high[1]), slice(low[0], high[0]))
    visible = (weight_a >= -1e-9) & (weight_b >= -1e-9) & (weight_c >= -1e-9) & (z > depth[region])
    on_edge = np.zeros_like(visible)
    sides = ((weight_c, bx - ax, by - ay), (weight_a, cx - bx, cy - by), (weight_b, ax - cx, ay - cy))
    for (weight, dx, dy), edge in zip(sides, is_edge):
        if edge:
            on_edge |= weight * abs(double_area) < _LINE * np.hypot(dx, dy)
    depth[region][visible] = z[visible]
    image[region][visible] = np.where(on_edge[..., None], _EDGE_COLOUR, colour)[visible]


def _inside(corners, columns, lines):
    low, high = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
    return high[0] > 0 and high[1] > 0 and low[0] < columns and low[1] < lines


def _unit(vector):
    vector = np.asarray(vector, float)
    return vector / np.linalg.norm(vector)
