"""The demo: a delta wing with anisotropic rows along its leading edge, made by FreeCAD without a GUI.

Run by `make demo`, or from the add-on's folder: freecadcmd resources/examples/wing_demo.py
Leaves wing.FCStd, wing.inp, wing.vtu, report.json and wing.png in build/demo.
"""

import json
import shutil
import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUT = ROOT / "build" / "demo"


def run():
    sys.path.append(str(ROOT / "Mod"))
    import anisoquad
    import FreeCAD
    import Mesh
    from anisoquad.io import write_mesh
    from anisoquad.objects.quad_mesh_object import result_of
    from anisoquad.picture import save_png
    from anisoquad.summary import quality_table

    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    doc = FreeCAD.newDocument("wing")
    wing = doc.addObject("Mesh::Feature", "Wing")
    wing.Mesh = Mesh.Mesh(str(ROOT / "tests" / "data" / "wing_delta.off"))
    leading_edge = json.loads((ROOT / "tests" / "data" / "wing_delta.json").read_text())["leading_edge"]
    quads = anisoquad.make_quad_mesh(doc, base=wing, sources=[leading_edge], passes=[4, 2, 2])
    doc.recompute()
    if not quads.isValid():
        raise RuntimeError(quads.getStatusString())
    doc.saveAs(str(OUT / "wing.FCStd"))

    mesh = result_of(quads)
    write_mesh(OUT / "wing.inp", mesh)
    write_mesh(OUT / "wing.vtu", mesh)
    (OUT / "report.json").write_text(quads.Report + "\n")
    save_png(OUT / "wing.png", two_views(mesh, wing, leading_edge))

    print("\n" + quality_table(mesh.report))
    print("\n" + "\n".join(str(path.relative_to(ROOT)) for path in sorted(OUT.iterdir())))
    return 0 if mesh.valid and quads.FemMesh.QuadrangleCount == len(mesh.quads) else 1


def two_views(mesh, wing, leading_edge):
    """The whole wing, and below it the middle of the leading edge."""
    import numpy as np
    from anisoquad.picture import render, row_colours

    points = np.array([list(wing.Mesh.Points[i].Vector) for i in (leading_edge[0], leading_edge[-1])])
    box = wing.Mesh.BoundBox
    colours = row_colours(mesh.row, mesh.pass_)
    above = np.array((-0.3, 0.1, 1.0))
    along = points[1] - points[0]
    forward = np.cross(above, along) / np.linalg.norm(np.cross(above, along))
    whole = render(mesh.points, mesh.quads, colours, above, (-1, 0, 0), list(box.Center), 1.08 * box.YLength, (1600, 2050))
    width = 0.45 * np.linalg.norm(along)
    middle = points.mean(axis=0) - 0.28 * width * forward
    close = render(mesh.points, mesh.quads, colours, above, forward, middle, width, (1600, 1000))
    return np.concatenate([whole, np.full((12, 1600, 3), 255, np.uint8), close])


try:
    code = run()
except Exception:
    traceback.print_exc()
    code = 1
sys.stdout.flush()
# freecadcmd runs a script again after an exception, and would end with 0.
sys.exit(code)
