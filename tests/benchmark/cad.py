"""Meshing onto CAD shapes against their triangles alone: distance of the nodes from the shape, quality, time.

freecadcmd tests/benchmark/cad.py    prints the table; FreeCAD makes the shapes, and measures the distances by OpenCASCADE
"""

import os
import sys
import time
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Mod"), str(Path(__file__).resolve().parent)]

SIZE = 1.0 / 60.0  # of the diagonal
REPEATS = 2


def best_time(run):
    """(result, seconds) of the fastest of some runs."""
    best = None
    for _ in range(REPEATS):
        start = time.perf_counter()
        result = run()
        seconds = time.perf_counter() - start
        if best is None or seconds < best[1]:
            best = result, seconds
    return best


def distances(shape, mesh, cad_face):
    """Largest distance of the nodes of each quad from the face that the quad is on."""
    import numpy as np
    import Part

    largest = 0.0
    for index, face in enumerate(shape.Faces):
        for node in np.unique(mesh.quads[cad_face == index]):
            largest = max(largest, face.distToShape(Part.Vertex(*mesh.points[node]))[0])
    return largest


def compare(name, shape):
    """Rows of the table: triangles alone, then onto the shape; the same triangles, feature edges and options."""
    import anisoquad
    from anisoquad.cad import CadShape, CadSurface
    from anisoquad.meshing import with_feature_edges

    cad = CadShape.from_brep(shape.exportBrepToString(), name)
    points, triangles = cad.triangulate()
    options = anisoquad.Options(size=SIZE * cad.diagonal)
    surface = CadSurface(cad, points, triangles)
    alone_options = with_feature_edges(options, surface.feature_edges)
    alone, alone_time = best_time(lambda: anisoquad.quad_mesh(points, triangles, options=alone_options))
    onto, onto_time = best_time(lambda: anisoquad.quad_mesh(points, triangles, options=options, surface=CadSurface(cad, points, triangles)))
    faces_alone = nearest_faces(shape, alone.points[alone.quads].mean(axis=1))
    rows = []
    for way, mesh, face, seconds in (("triangles", alone, faces_alone, alone_time), ("CAD", onto, onto.cad_face, onto_time)):
        report = mesh.report
        rows.append((name, len(shape.Faces), way, len(mesh.quads), distances(shape, mesh, face) / cad.diagonal, report["inverted"],
                     report["scaled_jacobian"]["min"], report["scaled_jacobian"]["mean"], seconds, seconds / alone_time))
    return rows


def nearest_faces(shape, points):
    """The face that is nearest to each point."""
    import numpy as np
    import Part

    boxes = [face.BoundBox for face in shape.Faces]
    for box in boxes:
        box.enlarge(1e-2 * shape.BoundBox.DiagonalLength)
    found = []
    for point in points.tolist():
        vertex = Part.Vertex(*point)
        near = [i for i, box in enumerate(boxes) if box.isInside(vertex.Point)]
        found.append(min(near, key=lambda i: shape.Faces[i].distToShape(vertex)[0]))
    return np.array(found)


def table(rows):
    lines = ["| shape | faces | nodes on | quads | largest distance / diagonal | inverted | min SJ | mean SJ | seconds | × |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for name, faces, way, quads, distance, inverted, least, mean, seconds, ratio in rows:
        lines.append(f"| {name} | {faces} | {way} | {quads} | {distance:.1e} | {inverted} | {least:.3f} | {mean:.3f} | {seconds:.2f} | {ratio:.2f} |")
    return "\n".join(lines)


if __name__ == "__main__" or sys.argv[-1].endswith("cad.py"):
    try:
        from cad_shapes import SHAPES

        rows = []
        for name, make in SHAPES.items():
            rows += compare(name, make())
            print("\n" + table(rows[-2:]), flush=True)
        print("\n" + table(rows))
    except Exception:
        traceback.print_exc()
        os._exit(1)
    sys.stdout.flush()
    os._exit(0)
