"""Example: a swept wing as a Part loft, its leading edge an edge of the shape.

freecadcmd resources/examples/swept_wing.py
Leaves swept_wing.FCStd in build/examples.
"""

import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(Path(__file__).resolve().parent))
OUT = ROOT / "build" / "examples"
SPAN, SWEEP, ROOT_CHORD, TIP_CHORD, THICKNESS = 2000.0, 1000.0, 1000.0, 500.0, 0.12  # mm; thickness over chord
SIZE = 40.0  # mm; edges of the triangles, which are those of the quads


def section(chord, x, y):
    """A closed wire of two curves that meet at the leading edge, so that the loft has an edge there."""
    import FreeCAD
    import Part
    from airfoil import naca_half

    half = naca_half(THICKNESS, chord)
    curves = []
    for side in (1, -1):
        curve = Part.BSplineCurve()
        curve.interpolate([FreeCAD.Vector(x + along, y, side * up) for along, up in half])
        curves.append(curve.toShape())
    return Part.Wire(Part.__sortEdges__(curves))


def leading_edge(shape):
    """The name of the edge from leading edge to leading edge."""
    import FreeCAD

    ends = [FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(SWEEP, SPAN, 0)]
    for index, edge in enumerate(shape.Edges):
        if all(any(vertex.Point.distanceToPoint(end) < 1e-6 for vertex in edge.Vertexes) for end in ends):
            return f"Edge{index + 1}"
    raise RuntimeError("the loft has no leading edge")


def make(doc):
    """Add shape, triangles, source and quad mesh to a document. Returns the quad mesh object, not yet recomputed."""
    import anisoquad
    import Part

    wing = doc.addObject("Part::Feature", "SweptWing")
    wing.Shape = Part.makeLoft([section(ROOT_CHORD, 0.0, 0.0), section(TIP_CHORD, SWEEP, SPAN)], True)
    triangles = anisoquad.make_triangles(doc, wing, max_length=SIZE)
    source = anisoquad.make_source(doc, triangles, edges=(wing, [leading_edge(wing.Shape)]), anisotropy=8, name="LeadingEdge")
    return anisoquad.make_quad_mesh(doc, base=triangles, sources=[source], options=anisoquad.Options(prepare=False))


def main(make_in, name):
    """Make an example in a document of its own, and save it."""
    sys.path.append(str(ROOT / "Mod"))
    import FreeCAD

    doc = FreeCAD.newDocument(name)
    quads = make_in(doc)
    doc.recompute()
    if not quads.isValid():
        raise RuntimeError(quads.getStatusString())
    OUT.mkdir(parents=True, exist_ok=True)
    doc.saveAs(str(OUT / f"{name}.FCStd"))
    print(f"{quads.Quads} quads, worst scaled Jacobian {quads.MinScaledJacobian:.3f}")
    print("\n".join(quads.RowsPerPass))


if __name__ == "__main__" or sys.argv[-1].endswith("swept_wing.py"):
    try:
        main(make, "swept_wing")
    except Exception:
        traceback.print_exc()
        sys.exit(1)
    sys.exit(0)
