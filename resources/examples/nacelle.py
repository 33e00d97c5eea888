"""Example: an engine nacelle, a section revolved round its axis; the lip is a closed source.

freecadcmd resources/examples/nacelle.py
Leaves nacelle.FCStd in build/examples.
"""

import sys
import traceback
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))

RADIUS, CHORD, THICKNESS = 600.0, 1500.0, 0.14  # mm; thickness over chord
DEFLECTION = 0.3  # mm, of the triangles from the shape


def shape():
    """The nacelle's surface: two faces that meet at the lip and at the trailing edge."""
    import FreeCAD
    import Part
    from airfoil import naca_half

    curves = []
    for side in (1, -1):
        curve = Part.BSplineCurve()
        curve.interpolate([FreeCAD.Vector(along, 0, RADIUS + side * up) for along, up in naca_half(THICKNESS, CHORD)])
        curves.append(curve.toShape())
    section = Part.Wire(Part.__sortEdges__(curves))
    return section.revolve(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(1, 0, 0), 360)


def lip(nacelle):
    """The name of the circle at the front."""
    import Part

    for index, edge in enumerate(nacelle.Edges):
        if isinstance(edge.Curve, Part.Circle) and abs(edge.Curve.Center.x) < 1e-6:
            return f"Edge{index + 1}"
    raise RuntimeError("the nacelle has no lip")


def make(doc):
    """Add shape, triangles, source and quad mesh to a document. Returns the quad mesh object, not yet recomputed."""
    import anisoquad

    nacelle = doc.addObject("Part::Feature", "Nacelle")
    nacelle.Shape = shape()
    triangles = anisoquad.make_triangles(doc, nacelle, deflection=DEFLECTION)
    source = anisoquad.make_source(doc, triangles, edges=(nacelle, [lip(nacelle.Shape)]), anisotropy=4, name="Lip")
    return anisoquad.make_quad_mesh(doc, base=triangles, sources=[source])


if __name__ == "__main__" or sys.argv[-1].endswith("nacelle.py"):
    try:
        from swept_wing import main

        main(make, "nacelle")
    except Exception:
        traceback.print_exc()
        sys.exit(1)
    sys.exit(0)
