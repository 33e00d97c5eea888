"""The CAD shapes on which meshing onto the shape is measured and tested, made by FreeCAD's Part. Lengths in millimetres.

freecadcmd tests/benchmark/cad_shapes.py     leaves them as .brep in build/cad_shapes
"""

import math
import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "resources" / "examples"))


def _vector(*coordinates):
    import FreeCAD

    return FreeCAD.Vector(*coordinates)


def section(chord, place, thickness=0.12, turn=0.0):
    """A closed wire of an airfoil's upper and lower curve, turned by degrees about its quarter chord."""
    import FreeCAD
    import Part
    from airfoil import naca_half

    curves = []
    for side in (1, -1):
        curve = Part.BSplineCurve()
        curve.interpolate([_vector(along - 0.25 * chord, 0, side * up) for along, up in naca_half(thickness, chord)])
        curves.append(curve.toShape())
    wire = Part.Wire(Part.__sortEdges__(curves))
    wire.Placement = FreeCAD.Placement(_vector(*place), FreeCAD.Rotation(_vector(0, 1, 0), turn))
    return wire


def naca_wing(span=2000.0):
    """A swept wing, lofted between two sections."""
    import Part

    return Part.makeLoft([section(1000, (250, 0, 0)), section(500, (850, span, 0))], True)


def wing_fuselage():
    """Half of a fuselage with a wing, and a fillet where they meet."""
    import Part

    body = Part.makeCylinder(300, 2400, _vector(-900, 0, 0), _vector(1, 0, 0))
    wing = Part.makeLoft([section(900, (225, 0, 0)), section(450, (600, 1500, 0))], True)
    fused = body.fuse(wing)
    joint = [edge for edge in fused.Edges
             if all(abs(math.hypot(p.y, p.z) - 300) < 1e-3 for p in edge.discretize(9)) and abs(edge.BoundBox.XLength) > 10
             and edge.BoundBox.YMin > 0 and edge.BoundBox.XLength < 1000]
    return fused.makeFillet(25, joint)


def nacelle():
    """An engine's cowling: an airfoil revolved about the engine's axis."""
    import Part

    wire = section(1000, (250, 0, 500))
    faces = [edge.revolve(_vector(0, 0, 0), _vector(1, 0, 0), 360) for edge in wire.Edges]
    return Part.makeShell([face for shape in faces for face in shape.Faces])


def propeller_blade():
    """A twisted, tapered blade lofted through five sections."""
    import Part

    stations = ((100, 90, 0.20, 60), (250, 110, 0.15, 42), (450, 105, 0.12, 30), (650, 80, 0.10, 22), (800, 45, 0.08, 18))
    return Part.makeLoft([section(chord, (0, radius, 0), thickness, turn) for radius, chord, thickness, turn in stations], True)


def mechanical_part():
    """A bracket with a boss, ribs, bores, pockets and rounded edges: more than 50 faces."""
    import Part

    part = Part.makeBox(200, 120, 20)
    part = part.fuse(Part.makeBox(20, 120, 90))
    part = part.fuse(Part.makeCylinder(30, 50, _vector(130, 60, 0)))
    for y in (10, 98):
        rib = Part.Face(Part.makePolygon([_vector(20, y, 20), _vector(80, y, 20), _vector(20, y, 70), _vector(20, y, 20)]))
        part = part.fuse(rib.extrude(_vector(0, 12, 0)))
    part = part.cut(Part.makeCylinder(18, 60, _vector(130, 60, -5)))
    for x, y in ((100, 15), (100, 105), (185, 15), (185, 105)):
        part = part.cut(Part.makeCylinder(6, 30, _vector(x, y, -5)))
        part = part.cut(Part.makeCylinder(10, 10, _vector(x, y, 14)))
    for y in (35, 85):
        part = part.cut(Part.makeCylinder(9, 40, _vector(-10, y, 65), _vector(1, 0, 0)))
    for x, y in ((106, 60), (154, 60), (130, 36), (130, 84)):
        part = part.cut(Part.makeCylinder(3, 20, _vector(x, y, 38)))
    for x in (45, 62):
        part = part.cut(Part.makeBox(8, 40, 10, _vector(x, 40, 12)))
    part = part.removeSplitter()
    upright = [edge for edge in part.Edges if len(edge.Vertexes) == 2 and edge.BoundBox.ZLength > 15
               and edge.BoundBox.XLength + edge.BoundBox.YLength < 1e-6 and edge.Vertexes[0].X > 190]
    part = part.makeFillet(12, upright)
    top = [edge for edge in part.Edges if len(edge.Vertexes) == 2 and abs(edge.BoundBox.ZMin - 90) < 1e-6 and edge.BoundBox.YLength > 100]
    return part.makeFillet(4, top)


SHAPES = {"naca_wing": naca_wing, "wing_fuselage": wing_fuselage, "nacelle": nacelle, "propeller_blade": propeller_blade,
          "mechanical_part": mechanical_part}


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in SHAPES.items():
        shape = make()
        shape.exportBrep(str(folder / f"{name}.brep"))
        print(f"{name}: {len(shape.Faces)} faces, {len(shape.Edges)} edges, {'valid' if shape.isValid() else 'INVALID'}")


if __name__ == "__main__" or sys.argv[-1].endswith("cad_shapes.py"):
    try:
        write(ROOT / "build" / "cad_shapes")
    except Exception:
        traceback.print_exc()
        sys.exit(1)
    sys.exit(0)
