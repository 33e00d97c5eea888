"""The paper's Figures 3, 6 and 7 from our own run: each pass at the leading edge, its rows and then its merge, and the result.

usage: PYTHONPATH=Mod /usr/bin/python3 tests/benchmark/paper_figures.py [FOLDER] [WING]
Writes one picture a stage into FOLDER (default build/figures), and figures.png with rows left and merge right.
"""

import sys
from pathlib import Path

import numpy as np
import wing

import anisoquad
from anisoquad.picture import render, row_colours, save_png

SIZE = (1000, 640)
ABOVE = np.array((-0.3, 0.1, 1.0))


def main(folder="build/figures", name="wing_delta"):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    points, triangles, line = wing.read(name)
    source = anisoquad.Source(line, passes=[4, 2, 2])
    mesh = anisoquad.quad_mesh(points, triangles, [source], anisoquad.Options(record_stages=True))
    start, end = points[line[0]], points[line[-1]]
    pictures = []
    stages = [stage for stage in mesh.stages if stage[0].startswith("pass") or stage[0] == "result"]
    for number, (title, stage_points, faces, row) in enumerate(stages):
        colours = row_colours(row, np.ones_like(row))
        picture = close_up(stage_points, faces, colours, start, end)
        pictures.append(picture)
        file = folder / f"{number + 1}_{title.replace(':', '').replace(' ', '_')}.png"
        save_png(file, picture)
        print(file)
    whole = whole_wing(mesh, points)
    save_png(folder / "whole.png", whole)
    pictures.append(whole)
    save_png(folder / "figures.png", in_pairs(pictures))
    print(folder / "figures.png")


def close_up(points, faces, colours, start, end):
    """The middle of the leading edge, seen from above, the edge at the top."""
    along = end - start
    forward = np.cross(ABOVE, along) / np.linalg.norm(np.cross(ABOVE, along))
    width = 0.4 * np.linalg.norm(along)
    return render(points, faces, colours, ABOVE, forward, (start + end) / 2 - 0.28 * width * forward, width, SIZE)


def whole_wing(mesh, points):
    low, high = points.min(axis=0), points.max(axis=0)
    width = 1.15 * max((high - low)[1], (high - low)[0] * SIZE[0] / SIZE[1])
    return render(mesh.points, mesh.quads, row_colours(mesh.row, mesh.pass_), ABOVE, (-1, 0, 0), (low + high) / 2, width, SIZE)


def in_pairs(pictures):
    """Two pictures a line, with a white gap."""
    blank = np.full_like(pictures[0], 255)
    gap = 12
    lines = []
    for left in range(0, len(pictures), 2):
        pair = (pictures[left : left + 2] + [blank])[:2]
        lines.append(np.concatenate([pair[0], blank[:, :gap], pair[1]], axis=1))
        lines.append(np.full((gap, lines[0].shape[1], 3), 255, np.uint8))
    return np.concatenate(lines[:-1])


if __name__ == "__main__":
    main(*sys.argv[1:])
